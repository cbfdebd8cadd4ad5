#include "host/io/look_at.hpp"

#include "host/core/pinhole.hpp"

namespace quell::io {

std::optional<Matrix4> lookAtMatrix(const LookAt& view, double aspect) {
  const bool alongX = view.axis == FovAxis::X || (view.axis == FovAxis::Smaller && aspect < 1.0) ||
                      (view.axis == FovAxis::Larger && aspect >= 1.0);
  const double focal = focalLength(view.fovDegrees);
  return pinholeMatrix(
      view.eye, view.target, view.up,
      alongX ? std::array<double, 2>{focal, focal * aspect} : std::array<double, 2>{focal / aspect, focal});
}

}  // namespace quell::io

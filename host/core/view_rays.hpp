// Where the pixels of a camera look.
#pragma once

#include <array>
#include <quell/camera.hpp>
#include <quell/image_view.hpp>

namespace quell {

/// True if clip.w does not depend on the position, up to rounding.
bool isOrthographic(const Matrix4& worldToClip);

/// Camera-relative points at view depth 1: that of pixel (x, y) is origin + x * stepX + y * stepY.
struct ViewRays {
  std::array<double, 3> origin{}, stepX{}, stepY{};

  std::array<double, 3> at(int x, int y) const;
};
/// Of a perspective camera; `jitterPx` as Camera has it. Throws Error(InvalidArgument) for a singular
/// matrix.
ViewRays viewRays(const Matrix4& worldToClip, const std::array<double, 2>& jitterPx, Size size);

}  // namespace quell

// Perspective cameras by eye, target and field of view.
#pragma once

#include <array>
#include <optional>
#include <quell/camera.hpp>

namespace quell::io {

/// Which side of the picture the field of view spans: renderers differ.
enum class FovAxis { X, Y, Smaller, Larger };

struct LookAt {
  std::array<double, 3> eye{};     ///< world, scene units
  std::array<double, 3> target{};  ///< the middle of the picture shows this point
  std::array<double, 3> up{};      ///< points up in the picture; any length, not along the view axis
  double fovDegrees = 0.0;         ///< in (0, 180)
  FovAxis axis = FovAxis::Y;
};

/// In the convention of quell::Camera, clip.w being the view depth and row 2 the same; `aspect`: width by height. Nothing
/// where eye and target are one point or `up` lies along the line between them.
std::optional<Matrix4> lookAtMatrix(const LookAt& view, double aspect);

}  // namespace quell::io

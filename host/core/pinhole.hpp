// Matrices of pinhole cameras, for the API and for what reads camera files.
#pragma once

#include <array>
#include <optional>
#include <quell/camera.hpp>

namespace quell {

/// Half a picture's height or width in clip space over its tangent, for a field of view across it in degrees, (0, 180).
double focalLength(double fovDegrees);

/// World to clip in the convention of Camera, clip.w being the view depth and row 2 the same; world space, scene units.
/// `focal`: focalLength() along x and y. Nothing where eye and target are one point or `up` lies along the line between.
std::optional<Matrix4> pinholeMatrix(const std::array<double, 3>& eye, const std::array<double, 3>& target,
                                     const std::array<double, 3>& up, const std::array<double, 2>& focal);

}  // namespace quell

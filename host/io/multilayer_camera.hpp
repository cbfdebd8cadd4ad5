// The camera of a frame from what it shows: world positions and view depth.
#pragma once

#include <optional>
#include <quell/camera.hpp>

#include "host/io/image.hpp"

namespace quell::io {

/// View depth from which on a pixel shows the sky (Cycles writes 1e10; a half becomes infinite).
constexpr float kSkyDepth = 1e9f;

/// World to clip of a perspective camera whose pixel (x, y) shows `positionWorld` (3 channels, scene units) at this
/// depth along the view axis (1 channel): clip.w is the depth, and clip.x = ndc.x * clip.w and clip.y are linear in the
/// position, so three weighted least-squares fits of four unknowns find the rows; row 2 is 0.
/// Nothing where the surfaces are too few or all in one plane, or where no perspective camera fits to two pixels.
std::optional<Matrix4> findCamera(const Image& positionWorld, const Image& depth);

/// World positions (3 channels) from view depth; 0 for the sky. Nothing for an orthographic or singular matrix.
std::optional<Image> positionsFromDepth(const Matrix4& worldToClip, const Image& depth);

}  // namespace quell::io

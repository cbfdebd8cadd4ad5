// The camera of a frame from what it shows: world positions and view depth.
#pragma once

#include <optional>
#include <quell/camera.hpp>

#include "host/io/camera_fit.hpp"
#include "host/io/image.hpp"

namespace quell::io {

/// View depth from which on a pixel shows the sky (Cycles writes 1e10; a half becomes infinite).
constexpr float kSkyDepth = 1e9f;

/// The camera whose pixel (x, y) shows `positionWorld` (3 channels, scene units) at this depth along the view axis
/// (1 channel); see fitCamera(). Pixels that are not finite or that no common camera explains are left out.
FoundCamera findCamera(const Image& positionWorld, const Image& depth);

/// Stands in where no camera can be found: looks against the mean normal (3 channels) at the median of the surfaces, from
/// their median depth. Good enough to tell near from far; where pixels lay in other frames it does not say.
Matrix4 standInCamera(const Image& positionWorld, const Image& normalWorld, const Image& depth);

/// World positions (3 channels) from view depth; 0 for the sky. Nothing for an orthographic or singular matrix.
std::optional<Image> positionsFromDepth(const Matrix4& worldToClip, const Image& depth);

}  // namespace quell::io

// Depth along the view axis where files have distances along rays, and no camera.
#pragma once

#include <optional>

#include "host/io/image.hpp"

namespace quell::io {

/// View depth (1 channel, scene units) of surfaces from their world positions (3 channels) and distances along their rays
/// (1 channel), which may start off the eye, as at a near plane; kNoSurfaceDepth elsewhere. The eye is where distances to
/// the positions agree with those, but for one constant; the view axis is the row of a perspective camera that all rays
/// share. Nothing where surfaces are too few, or do not tell. Least squares: whether a camera fits, findCamera() says.
std::optional<Image> viewDepthFromRays(const Image& positionWorld, const Image& rayDepth);

}  // namespace quell::io

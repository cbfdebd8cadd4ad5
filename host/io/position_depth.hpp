// Depth along the view axis where files have world positions and neither depth nor a camera.
#pragma once

#include "host/io/image.hpp"

namespace quell::io {

/// View depth (1 channel, scene units) of surfaces, which have a normal (3 channels) other than 0, from their world positions
/// (3 channels) alone; kNoSurfaceDepth elsewhere. A pixel's coordinates are quotients of two linear functions of its
/// position (direct linear transformation; Hartley and Zisserman, Multiple View Geometry, section 7.1); the denominator, in
/// scene units, is the depth. Robust as fitCamera(). All surfaces at depth 1 where positions do not tell, as in one plane or
/// without perspective: whether a camera fits, findCamera() says.
Image viewDepthFromPositions(const Image& positionWorld, const Image& normalWorld);

}  // namespace quell::io

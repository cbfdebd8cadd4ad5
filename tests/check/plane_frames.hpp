// A textured wall seen by a camera that moves and turns, with noise: the smallest frames that all checks have something
// to say about.
#pragma once

#include "host/io/frame_sequence.hpp"

namespace quell::tests {

constexpr int kPlaneWidth = 160, kPlaneHeight = 90;

/// Wall z = 0 with a checkerboard, 5 units away; the camera moves to the right and turns by 0.02 rad a frame. Radiance with
/// exponential noise, normal, position and albedo; view depth only where `depth` asks for it, instead of position.
io::FrameData planeFrame(int number, bool depth = false);

/// By 4x4 transposition, as a renderer has them that keeps columns.
void transpose(Matrix4& matrix);
/// Rows of all images bottom up.
void turnOver(io::FrameData& frame);

}  // namespace quell::tests

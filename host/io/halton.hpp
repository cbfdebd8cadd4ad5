// Where jittered primary rays go inside their pixel.
#pragma once

#include <array>

namespace quell::io {

/// Frames after which jitterPxOf() starts again.
constexpr int kJitterPeriod = 16;

/// Point `index` (>= 1) of the Halton sequence in bases 2 and 3, in (0, 1). Source: J. H. Halton, Algorithm 247:
/// Radical-inverse quasi-random point sequence, 1964.
std::array<double, 2> halton23(int index);

/// The offset of a frame (>= 0) as quell::Camera has it, in (-0.5, 0.5); never the pixel centre itself.
std::array<double, 2> jitterPxOf(int frame);

}  // namespace quell::io

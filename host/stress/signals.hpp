// Radiance of a block: lighting with the noise of one sample a pixel, and the faults that renderers produce.
#pragma once

#include "host/stress/block.hpp"
#include "host/stress/random.hpp"

namespace quell::stress {

/// Lighting of the block's surfaces: smooth over the block, shaded by the normal, cut by a shadow's edge or
/// nothing but noise, by turns; noise-free in a quarter of the blocks; brightness 1e-3 to 1e3.
void addLighting(Block& block, Random& random);

/// The same without shadows, whose edges no combination of smooth features can follow: fits overshoot there
/// by up to two thirds of the step, however exactly they are solved.
void addGentleLighting(Block& block, Random& random);

}  // namespace quell::stress

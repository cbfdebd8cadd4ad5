// Blocks whose radiance, or missing pixels, make trouble; their surfaces are harmless unless said otherwise.
#pragma once

#include "host/stress/block.hpp"
#include "host/stress/random.hpp"

namespace quell::stress {

/// One pixel brighter or darker than all others, which are equal.
void makeOddColor(Block& block, Random& random);
/// 1 to 12 pixels with a sample on a surface of any kind; the others are sky or surfaces without one.
void makeFewValid(Block& block, Random& random);
/// Up to 1 % of the pixels have a channel of 1e30.
void makeFireflies(Block& block, Random& random);
/// All below the smallest normal float.
void makeDenormalColors(Block& block, Random& random);
void makeZeroColors(Block& block, Random& random);
/// Up to all pixels negative.
void makeNegativeColors(Block& block, Random& random);
/// Up to 90 % of the pixels with NaN or Inf in a channel of the radiance, or in the position.
void makeBrokenColors(Block& block, Random& random);
void makeBrokenPositions(Block& block, Random& random);
/// Surfaces without a single sample.
void makeAllBroken(Block& block, Random& random);
void makeSky(Block& block, Random& random);

}  // namespace quell::stress

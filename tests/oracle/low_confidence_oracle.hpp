// Oracle of the stage low_confidence, see kernels/low_confidence.cl.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

/// Cells of 16x8 pixels that cover the image.
inline Size confidenceCellsOf(Size size) { return {(size.width + 15) / 16, (size.height + 7) / 8}; }

/// The least confidence of cells of 16x8 pixels, of those with a weight; 1 without any.
ExactPlanes lowConfidenceOracle(const Planes& confidence, const Planes& weights);

}  // namespace quell::tests

// Oracle of the stage low_confidence, see kernels/low_confidence.cl.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

/// The least confidence of cells of 16x8 pixels, of those with a weight; 1 without any.
ExactPlanes lowConfidenceOracle(const Planes& confidence, const Planes& weights);

}  // namespace quell::tests

// Double-precision oracle of the stage accumulate_filtered (Koskela et al. 2019, phase III), see
// kernels/accumulate_filtered.cl.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

struct AccumulateFilteredInputs {
  Planes fitted;            ///< 3 planes
  Planes filteredPrev;      ///< 3 planes
  Planes pixelPrev;         ///< 2 planes
  Planes reprojectionMask;  ///< 1 plane
  Planes historyLength;     ///< 1 plane
  double leastWeight = 0.1;
};

/// Filtered irradiance, 3 planes.
ExactPlanes accumulateFilteredOracle(const AccumulateFilteredInputs& inputs);

}  // namespace quell::tests

// Double-precision oracle of the stage temporal_antialiasing (Koskela et al. 2019, phase III, after Karis
// 2014), see kernels/temporal_antialiasing.cl.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

struct TemporalAntialiasingInputs {
  Planes encoded;           ///< 3 planes, [0, 1]
  Planes antialiasedPrev;   ///< 3 planes, [0, 1]
  Planes pixelPrev;         ///< 2 planes
  Planes reprojectionMask;  ///< 1 plane
  double newestWeight = 0.2;
};

/// Display-encoded values, 3 planes.
ExactPlanes temporalAntialiasingOracle(const TemporalAntialiasingInputs& inputs);

}  // namespace quell::tests

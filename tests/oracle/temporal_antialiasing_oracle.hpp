// Double-precision oracle of the stage temporal_antialiasing (Koskela et al. 2019, phase III, after Karis
// 2014), see kernels/temporal_antialiasing.cl.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

struct TemporalAntialiasingInputs {
  Planes denoised;          ///< linear radiance, 3 planes
  Planes antialiasedPrev;   ///< the same
  Planes pixelPrev;         ///< 2 planes
  Planes reprojectionMask;  ///< 1 plane
  Planes viewDepth;         ///< 1 plane; 0: background
  bool antialiasBackground = true;
  double newestWeight = 0.2;
  double silhouetteWeight = 0.2;
};

/// Linear radiance, 3 planes.
ExactPlanes temporalAntialiasingOracle(const TemporalAntialiasingInputs& inputs);

}  // namespace quell::tests

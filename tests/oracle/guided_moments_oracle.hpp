// Double-precision oracle of the stage guided_moments, see kernels/guided_moments.cl; and cells of pixels.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

/// Cells of `subsampling` pixels square that cover the image.
Size cellsOf(Size size, int subsampling);

struct GuidedMomentsInputs {
  Planes irradiance;  ///< 3 planes a signal
  Planes guides;      ///< of accumulate_noisy
  Planes viewDepth;   ///< 1 plane
  int subsampling = 1;

  int signals() const { return irradiance.count / 3; }
};

struct GuidedMomentsExact {
  ExactPlanes sums;        ///< QUELL_GUIDED_SUMS planes a signal, of cells
  ExactPlanes magnitudes;  ///< of the terms without their signs
};

GuidedMomentsExact guidedMomentsOracle(const GuidedMomentsInputs& inputs);

}  // namespace quell::tests

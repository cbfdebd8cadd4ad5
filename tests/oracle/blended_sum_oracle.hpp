// Double-precision oracle of the stage blended_sum (Koskela et al. 2019, eq. (6), overlapping windows), see
// kernels/blended_sum.cl.
#pragma once

#include "kernels/gram_params.h"
#include "tests/oracle/fit_oracle.hpp"

namespace quell::tests {

struct BlendedSumInputs {
  Planes records;  ///< as the stage gram_solve writes them
  Planes guides;   ///< 7 planes, and 4 of materials where features need them
  FeatureNames list = defaultNames();
  GramParams params{};
  int tileEdge = 8;
};

struct BlendedSumExact {
  ExactPlanes fitted;     ///< 3 planes
  ExactPlanes magnitude;  ///< sum of the magnitudes of the terms: what rounding errors are relative to
};

BlendedSumExact blendedSumOracle(const BlendedSumInputs& inputs);

}  // namespace quell::tests

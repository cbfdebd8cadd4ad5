// Double-precision oracle of the stage weighted_sum (Koskela et al. 2019, eq. (6)), see
// kernels/weighted_sum.cl.
#pragma once

#include "tests/oracle/fit_oracle.hpp"

namespace quell::tests {

struct WeightedSumInputs {
  Planes records;  ///< as the stage fit writes them
  Planes guides;   ///< 7 planes, and 4 of materials where features need them
  FeatureNames list = defaultNames();
  FitParams params{};
};

struct WeightedSumExact {
  ExactPlanes fitted;     ///< 3 planes
  ExactPlanes magnitude;  ///< sum of the magnitudes of the terms: what rounding errors are relative to
};

WeightedSumExact weightedSumOracle(const WeightedSumInputs& inputs);

}  // namespace quell::tests

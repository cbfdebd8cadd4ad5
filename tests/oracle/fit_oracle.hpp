// Double-precision oracle of the stage fit (Koskela et al. 2019, phase II), see kernels/fit.cl. The noise
// comes from the same integer hash as on the device, so that both solve the same least-squares problem.
#pragma once

#include <vector>

#include "tests/oracle/feature_oracle.hpp"

namespace quell::tests {

struct FitInputs {
  Planes irradiance;  ///< 3 planes
  Planes guides;      ///< 7 planes, and 4 of materials where features need them
  FitParams params{};
  FeatureNames list = defaultNames();
};

struct FitExact {
  std::vector<FitRecord> records;
  std::vector<double> conditions;  ///< of the weighted matrix [T + N]; infinite where columns are dependent
};

FitExact fitOracle(const FitInputs& inputs);

/// The pixel of a row of a block's matrix; coordinates outside the image are mirrored into it.
struct BlockPixel {
  int x, y;
};
BlockPixel blockPixel(const FitParams& params, int block, int row);

}  // namespace quell::tests

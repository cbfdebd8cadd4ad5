// Double-precision oracle of the stage fit (Koskela et al. 2019, phase II), see kernels/fit.cl. The noise
// comes from the same integer hash as on the device, so that both solve the same least-squares problem.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "kernels/fit_params.h"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct FitInputs {
  Planes irradiance;  ///< 3 planes
  Planes guides;      ///< 7 planes
  FitParams params{};
};

using Coefficients = Eigen::Matrix<double, QUELL_FEATURES, QUELL_FIT_CHANNELS>;

/// The record of one block.
struct FitRecord {
  Coefficients coefficients = Coefficients::Zero();
  std::array<double, 3> anchor{}, scale{};
};

struct FitExact {
  std::vector<FitRecord> records;
  std::vector<double> conditions;  ///< of the weighted matrix [T + N]; infinite where columns are dependent
};

FitExact fitOracle(const FitInputs& inputs);

/// A record as the device stores it.
FitRecord unpackRecord(const Planes& records, int block);
Planes packRecords(const std::vector<FitRecord>& records);

/// T for one pixel: features without noise.
Eigen::Matrix<double, 1, QUELL_FEATURES> features(const Planes& guides, const FitRecord& record, int x,
                                                  int y);

/// The pixel of a row of a block's matrix; coordinates outside the image are mirrored into it.
struct BlockPixel {
  int x, y;
};
BlockPixel blockPixel(const FitParams& params, int block, int row);

}  // namespace quell::tests

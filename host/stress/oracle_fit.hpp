// The best fit there is, in double precision, and how far from it a solver's fit lies.
#pragma once

#include <Eigen/Core>

#include "host/stress/block_fitter.hpp"

namespace quell::stress {

using FeatureRow = Eigen::Matrix<double, 1, QUELL_FEATURES>;
using FeatureMatrix = Eigen::Matrix<double, Eigen::Dynamic, QUELL_FEATURES>;
using ColorMatrix = Eigen::Matrix<double, Eigen::Dynamic, QUELL_FIT_CHANNELS>;
using Coefficients = Eigen::Matrix<double, QUELL_FEATURES, QUELL_FIT_CHANNELS>;

/// The least-squares problem of one block: the pixels with a weight, features without noise, in the scaling
/// of a record (fit_params.h).
struct LeastSquares {
  FeatureMatrix features;   ///< one row a pixel, not weighted
  ColorMatrix colors;       ///< irradiance
  Eigen::VectorXd weights;  ///< (0, 1]
  FeatureMatrix predicted;  ///< features of all pixels that get a prediction, holes included
};
LeastSquares makeLeastSquares(const BlockInputs& inputs, const BlockFit& scaling);

/// A direction of the centred, normalised features with less than this share of their length counts as
/// dependent. Inputs are floats: of a surface fifty times as far away as it is large, 3e-6 of its extent is
/// rounding, and a fit to that would only follow the noise.
constexpr double kOracleRankTolerance = 1e-5;

/// Weighted least squares by rank-revealing QR with column pivoting.
struct OptimalFit {
  Coefficients coefficients = Coefficients::Zero();
  Eigen::Array3d residualEnergy = Eigen::Array3d::Zero();  ///< weighted, per channel
  double condition = 1.0;  ///< of the centred, normalised features; infinite where some are dependent
};
OptimalFit solveOptimally(const LeastSquares& problem);

/// A solver's coefficients, first feature first.
Coefficients coefficientsOf(const BlockFit& fit);

/// How far a fit lies from the optimal one. All are shares, the worst channel's; see stress_suite.hpp for
/// bounds.
struct FitErrors {
  double excessResidual = 0.0;  ///< residual energy above the least, per signal energy about its mean
  double prediction = 0.0;      ///< largest difference of predictions where there is data, per range
  double coefficient = 0.0;     ///< largest difference per largest coefficient; 0 where ill-conditioned
  double outsideRange = 0.0;    ///< largest distance of any prediction from the range of the data, per
                                ///< range; distances below the spacing of halves do not count
  bool finite = true;           ///< record, predictions and what weighted_sum wrote
};
FitErrors compareFit(const BlockInputs& inputs, const BlockFit& fit);

}  // namespace quell::stress

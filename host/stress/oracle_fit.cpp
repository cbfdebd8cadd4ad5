#include "host/stress/oracle_fit.hpp"

#include <algorithm>
#include <cmath>

#include "host/stress/least_squares.hpp"

namespace quell::stress {
namespace {

constexpr Eigen::Index kVaried = QUELL_FEATURES - 1;
// Coefficients are compared up to this condition: above, they are not determined to a useful number of
// digits.
constexpr double kComparedCondition = 100.0;
// A signal's range counts as at least this share of its largest value, the spacing of halves: less is a
// constant to the formats that radiance comes in, and not far above what single precision leaves of a
// constant's own sums.
constexpr double kLeastRange = 1.0 / 1024.0;
// Irradiance below this is nothing: products of two such numbers vanish in float, and so may the numbers.
constexpr double kLeastSignal = 1e-30;

// Of a float.
constexpr double kRounding = 6e-8;

using FeatureColumn = Eigen::Matrix<double, QUELL_FEATURES, 1>;
using Indices = std::vector<Eigen::Index>;

FeatureRow featuresOf(const std::array<float, kGuidePlanes>& guides, const BlockFit& scaling) {
  FeatureRow row;
  row[0] = 1.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double anchor = static_cast<double>(scaling.record[QUELL_FIT_ANCHOR + i]);
    const double w = (static_cast<double>(guides[QUELL_GUIDE_POSITION + i]) - anchor) *
                     static_cast<double>(scaling.record[QUELL_FIT_SCALE + i]);
    row[1 + axis] = static_cast<double>(guides[QUELL_GUIDE_NORMAL + i]);
    row[4 + axis] = w;
    row[7 + axis] = w * w;
  }
  return row;
}

bool isSurface(const std::array<float, kGuidePlanes>& guides) {
  return guides[QUELL_GUIDE_NORMAL] != 0.0f || guides[QUELL_GUIDE_NORMAL + 1] != 0.0f ||
         guides[QUELL_GUIDE_NORMAL + 2] != 0.0f;
}

template <class Values>
bool allFinite(const Values& values) {
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

bool isFinite(const BlockInputs& inputs, const BlockFit& fit) {
  bool finite = allFinite(fit.record);
  for (const auto& pixel : fit.fitted) finite = finite && allFinite(pixel);
  for (const auto& pixel : inputs.irradiance) finite = finite && allFinite(pixel);
  for (const auto& pixel : inputs.guides) finite = finite && allFinite(pixel);
  return finite;
}

double weightedEnergy(const Eigen::VectorXd& weights, const Eigen::VectorXd& values) {
  return weights.dot(values.cwiseAbs2());
}

void raise(double& worst, double value) { worst = std::max(worst, value); }

/// Raises the errors to those of one channel.
void compareChannel(const LeastSquares& problem, const OptimalFit& optimal, const FeatureColumn& coefficients,
                    Eigen::Index c, FitErrors& errors) {
  const Eigen::VectorXd color = problem.colors.col(c);
  const double weight = problem.weights.sum();
  const double mean = problem.weights.dot(color) / weight;
  const double low = color.minCoeff();
  const double high = color.maxCoeff();
  const double leastRange = std::max(kLeastRange * high, kLeastSignal);
  const double range = std::max(high - low, leastRange);
  const double signal =
      std::max(weightedEnergy(problem.weights, color.array() - mean), weight * leastRange * leastRange);

  const FeatureColumn wanted = optimal.coefficients.col(c);
  const Eigen::VectorXd predicted = problem.features * coefficients;
  raise(errors.excessResidual,
        (weightedEnergy(problem.weights, color - predicted) - optimal.residualEnergy[c]) / signal);
  raise(errors.prediction, (predicted - problem.features * wanted).cwiseAbs().maxCoeff() / range);
  const Eigen::VectorXd everywhere = problem.predicted * coefficients;
  raise(errors.outsideRange, (everywhere.maxCoeff() - high - leastRange) / range);
  raise(errors.outsideRange, (low - everywhere.minCoeff() - leastRange) / range);
  if (optimal.condition < kComparedCondition)
    raise(errors.coefficient, (coefficients - wanted).cwiseAbs().maxCoeff() /
                                  std::max(wanted.cwiseAbs().maxCoeff(), kLeastSignal));
}

}  // namespace

LeastSquares makeLeastSquares(const BlockInputs& inputs, const BlockFit& scaling) {
  Indices used, surfaces;
  for (std::size_t pixel = 0; pixel < kBlockPixels; ++pixel) {
    if (inputs.guides[pixel][QUELL_GUIDE_WEIGHT] > 0.0f) used.push_back(static_cast<Eigen::Index>(pixel));
    if (isSurface(inputs.guides[pixel])) surfaces.push_back(static_cast<Eigen::Index>(pixel));
  }
  const auto count = static_cast<Eigen::Index>(used.size());
  LeastSquares problem{FeatureMatrix(count, QUELL_FEATURES), ColorMatrix(count, QUELL_FIT_CHANNELS),
                       Eigen::VectorXd(count),
                       FeatureMatrix(static_cast<Eigen::Index>(surfaces.size()), QUELL_FEATURES)};
  for (Eigen::Index row = 0; row < count; ++row) {
    const auto pixel = static_cast<std::size_t>(used[static_cast<std::size_t>(row)]);
    problem.features.row(row) = featuresOf(inputs.guides[pixel], scaling);
    problem.weights[row] = static_cast<double>(inputs.guides[pixel][QUELL_GUIDE_WEIGHT]);
    for (Eigen::Index c = 0; c < QUELL_FIT_CHANNELS; ++c)
      problem.colors(row, c) = static_cast<double>(inputs.irradiance[pixel][static_cast<std::size_t>(c)]);
  }
  for (Eigen::Index row = 0; row < problem.predicted.rows(); ++row)
    problem.predicted.row(row) =
        featuresOf(inputs.guides[static_cast<std::size_t>(surfaces[static_cast<std::size_t>(row)])], scaling);
  return problem;
}

OptimalFit solveOptimally(const LeastSquares& problem) {
  OptimalFit fit;
  const double weight = problem.weights.sum();
  if (!(weight > 0.0)) return fit;
  const Eigen::VectorXd roots = problem.weights.cwiseSqrt();
  const FeatureRow means = problem.weights.transpose() * problem.features / weight;
  const Eigen::RowVector3d colorMeans = problem.weights.transpose() * problem.colors / weight;
  Eigen::MatrixXd centred =
      roots.asDiagonal() *
      (problem.features - means.replicate(problem.features.rows(), 1)).rightCols(kVaried);
  const Eigen::MatrixXd colors =
      roots.asDiagonal() * (problem.colors - colorMeans.replicate(problem.colors.rows(), 1));

  // A column whose deviation is rounding of its size is constant.
  Eigen::VectorXd inverseLength = Eigen::VectorXd::Zero(kVaried);
  for (Eigen::Index j = 0; j < kVaried; ++j) {
    const double size = (roots.asDiagonal() * problem.features.col(j + 1)).norm();
    const double length = centred.col(j).norm();
    if (length > kRounding * size) inverseLength[j] = 1.0 / length;
  }
  centred *= inverseLength.asDiagonal();
  const LeastSquaresSolution solution = leastSquares(centred, colors, kOracleRankTolerance);
  fit.residualEnergy = (colors - centred * solution.coefficients).colwise().squaredNorm().transpose().array();
  fit.coefficients.bottomRows<kVaried>() = inverseLength.asDiagonal() * solution.coefficients;
  fit.coefficients.row(0) = colorMeans - means.rightCols<kVaried>() * fit.coefficients.bottomRows<kVaried>();
  fit.condition = solution.condition;
  return fit;
}

Coefficients coefficientsOf(const BlockFit& fit) {
  Coefficients coefficients;
  for (int j = 0; j < QUELL_FEATURES; ++j)
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      coefficients(j, c) =
          static_cast<double>(fit.record[static_cast<std::size_t>(j * QUELL_FIT_CHANNELS + c)]);
  return coefficients;
}

FitErrors compareFit(const BlockInputs& inputs, const BlockFit& fit) {
  FitErrors errors;
  errors.finite = isFinite(inputs, fit);
  if (!errors.finite) return errors;
  const LeastSquares problem = makeLeastSquares(inputs, fit);
  const Coefficients coefficients = coefficientsOf(fit);
  if (problem.predicted.rows() == 0) return errors;
  if (problem.features.rows() == 0) {
    // Without data the only plausible prediction is nothing.
    errors.outsideRange = (problem.predicted * coefficients).cwiseAbs().maxCoeff() / kLeastSignal;
    return errors;
  }
  const OptimalFit optimal = solveOptimally(problem);
  for (Eigen::Index c = 0; c < QUELL_FIT_CHANNELS; ++c)
    compareChannel(problem, optimal, coefficients.col(c), c, errors);
  return errors;
}

}  // namespace quell::stress

#include "tests/oracle/gram_solve_oracle.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace quell::tests {
namespace {

// Features without the constant one.
constexpr int kVaried = QUELL_FEATURES - 1;
// Relative distance from a threshold within which rounding of sums decides.
constexpr double kWeightMargin = 1e-5;
constexpr double kVarianceMargin = 0.5;

using Matrix = Eigen::MatrixXd;

// Row-wise: [features | colour] in the scaling `to` from those in the scaling `from`. With w' = r w + t per
// axis, w'^2 = r^2 w^2 + 2 r t w + t^2.
GramMatrix changeOfScaling(const FitRecord& from, const FitRecord& to) {
  GramMatrix m = GramMatrix::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t i = std::size_t(axis);
    const int linear = 4 + axis, square = 7 + axis;
    const double r = to.scale[i] / from.scale[i];
    const double t = (from.anchor[i] - to.anchor[i]) * to.scale[i];
    m(linear, linear) = r;
    m(linear, 0) = t;
    m(square, square) = r * r;
    m(square, linear) = 2.0 * r * t;
    m(square, 0) = t * t;
  }
  return m;
}

// Covariances times the sum of weights; its first row and column are left 0.
GramMatrix centred(const GramMatrix& sums) { return sums - sums.col(0) * sums.row(0) / sums(0, 0); }

bool near(double value, double threshold, double margin) {
  return std::abs(value - threshold) < margin * threshold;
}

// Features that vary; the rest get no coefficient.
std::vector<int> variedFeatures(const GramMatrix& sums, const GramMatrix& covariance, GramFit& fit) {
  std::vector<int> varied;
  const double weight = sums(0, 0);
  if (near(weight, double(QUELL_GRAM_LEAST_WEIGHT), kWeightMargin)) fit.undecided = true;
  if (weight < double(QUELL_GRAM_LEAST_WEIGHT)) return varied;
  for (int j = 1; j <= kVaried; ++j) {
    const double least = double(QUELL_GRAM_VARIANCE_TOLERANCE) * sums(j, j);
    if (near(covariance(j, j), least, kVarianceMargin)) fit.undecided = true;
    if (covariance(j, j) > least) varied.push_back(j);
  }
  return varied;
}

double conditionOf(const Matrix& normal) {
  const Eigen::VectorXd inverse = normal.diagonal().cwiseSqrt().cwiseInverse();
  const Matrix unit = inverse.asDiagonal() * normal * inverse.asDiagonal();
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Matrix>(unit).eigenvalues();
  return values[values.size() - 1] / values[0];
}

}  // namespace

std::vector<WindowTile> windowTiles(const GramParams& params, bool overlap, int window) {
  if (!overlap) return {{window, 1.0}};
  std::vector<WindowTile> tiles;
  const int centreX = window % params.tilesX, centreY = window / params.tilesX;
  for (int y = centreY - 1; y <= centreY + 1; ++y) {
    for (int x = centreX - 1; x <= centreX + 1; ++x) {
      if (x < 0 || x >= params.tilesX || y < 0 || y >= params.tilesY) continue;
      const double tent = (x == centreX ? 1.0 : 0.5) * (y == centreY ? 1.0 : 0.5);
      tiles.push_back({y * params.tilesX + x, tent});
    }
  }
  return tiles;
}

GramWindow windowOfTiles(const GramSolveInputs& inputs, int number) {
  const std::vector<WindowTile> tiles = windowTiles(inputs.params, inputs.overlap, number);
  PositionRange range;
  for (const WindowTile& part : tiles) {
    const PositionRange& other = unpackTile(inputs.tiles, inputs.params, part.tile).range;
    range.include(other.low, other.high);
  }
  GramWindow window;
  window.scaling = scalingOf(range);
  for (const WindowTile& part : tiles) {
    const GramTile tile = unpackTile(inputs.tiles, inputs.params, part.tile);
    if (tile.range.empty()) continue;
    const GramMatrix m = changeOfScaling(scalingOf(tile.range), window.scaling);
    window.sums += part.tent * m * tile.sums * m.transpose();
  }
  return window;
}

GramWindow windowOfPixels(const GramInputs& inputs, int number) {
  const std::vector<WindowTile> tiles = windowTiles(inputs.params, inputs.overlap, number);
  PositionRange range;
  for (const WindowTile& part : tiles) {
    for (const BlockPixel pixel : tilePixels(inputs, part.tile)) {
      const FitRecord unscaled = scalingOf(PositionRange());
      const Eigen::RowVector3d p = features(inputs.guides, unscaled, pixel.x, pixel.y).segment<3>(4);
      range.include({p[0], p[1], p[2]}, {p[0], p[1], p[2]});
    }
  }
  GramWindow window;
  window.scaling = scalingOf(range);
  for (const WindowTile& part : tiles)
    for (const BlockPixel pixel : tilePixels(inputs, part.tile))
      addPixel(inputs, window.scaling, pixel, part.tent, window.sums);
  return window;
}

GramFit ridgeFit(const GramWindow& window, double noiseVariance) {
  GramFit fit;
  fit.record = window.scaling;
  const double weight = window.sums(0, 0);
  if (!(weight > 0.0)) return fit;
  const GramMatrix covariance = centred(window.sums);
  const std::vector<int> varied = variedFeatures(window.sums, covariance, fit);
  const Eigen::Index count = Eigen::Index(varied.size());
  Coefficients& coefficients = fit.record.coefficients;
  if (count > 0) {
    Matrix normal(count, count), right(count, QUELL_FIT_CHANNELS);
    for (Eigen::Index i = 0; i < count; ++i) {
      const int a = varied[std::size_t(i)];
      for (Eigen::Index j = 0; j < count; ++j) normal(i, j) = covariance(a, varied[std::size_t(j)]);
      normal(i, i) += weight * noiseVariance;
      right.row(i) = covariance.row(a).tail<QUELL_FIT_CHANNELS>();
    }
    fit.condition = conditionOf(normal);
    const Matrix solution = normal.ldlt().solve(right);
    for (Eigen::Index i = 0; i < count; ++i) coefficients.row(varied[std::size_t(i)]) = solution.row(i);
  }
  // The constant makes the mean prediction the mean colour.
  const GramMatrix mean = window.sums / weight;
  coefficients.row(0) = mean.row(0).tail<QUELL_FIT_CHANNELS>() -
                        mean.row(0).segment<kVaried>(1) * coefficients.bottomRows<kVaried>();
  return fit;
}

std::vector<GramFit> gramSolveOracle(const GramSolveInputs& inputs) {
  std::vector<GramFit> fits;
  for (int window = 0; window < gramTileCount(inputs.params); ++window)
    fits.push_back(ridgeFit(windowOfTiles(inputs, window), double(inputs.params.noiseVariance)));
  return fits;
}

}  // namespace quell::tests

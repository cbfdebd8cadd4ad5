#include "tests/oracle/gram_solve_oracle.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

namespace quell::tests {
namespace {

// Relative distance from a threshold within which rounding of sums decides.
constexpr double kWeightMargin = 1e-5;
constexpr double kVarianceMargin = 0.5;

using Matrix = Eigen::MatrixXd;

// Row-wise: [features | colour] in the scaling `to` from those in the scaling `from`. With v' = r v + t, a product of
// such variables becomes a sum over all ways to take r v or t for each.
GramMatrix changeOfScaling(const FitRecord& from, const FitRecord& to) {
  const FeatureNames& list = from.list;
  std::map<std::vector<std::string>, Eigen::Index> columns;
  for (const std::string& name : list.features)
    columns.emplace(factorsOf(name), Eigen::Index(columns.size()));
  GramMatrix m = GramMatrix::Identity(list.count() + QUELL_FIT_CHANNELS, list.count() + QUELL_FIT_CHANNELS);
  for (const std::string& name : list.features) {
    std::map<std::vector<std::string>, double> terms = {{{}, 1.0}};
    for (const std::string& factor : factorsOf(name)) {
      std::map<std::vector<std::string>, double> longer;
      const auto found = std::find(list.scaled.begin(), list.scaled.end(), factor);
      const std::size_t i = std::size_t(found - list.scaled.begin());
      const bool scaled = found != list.scaled.end();
      const double r = scaled ? to.scale[i] / from.scale[i] : 1.0;
      const double t = scaled ? (from.anchor[i] - to.anchor[i]) * to.scale[i] : 0.0;
      for (const auto& [factors, value] : terms) {
        std::vector<std::string> more = factors;
        more.insert(std::upper_bound(more.begin(), more.end(), factor), factor);
        longer[more] += r * value;
        if (t != 0.0) longer[factors] += t * value;
      }
      terms = longer;
    }
    const Eigen::Index row = columns.at(factorsOf(name));
    m(row, row) = 0.0;
    for (const auto& [factors, value] : terms) m(row, columns.at(factors)) += value;
  }
  return m;
}

// Covariances times the sum of weights; its first row and column are left 0.
GramMatrix centred(const GramMatrix& sums) { return sums - sums.col(0) * sums.row(0) / sums(0, 0); }

bool near(double value, double threshold, double margin) {
  return std::abs(value - threshold) < margin * threshold;
}

// Features that vary; the rest get no coefficient.
std::vector<Eigen::Index> variedFeatures(const GramMatrix& sums, const GramMatrix& covariance, GramFit& fit) {
  const Eigen::Index count = fit.record.list.count();
  const double leastWeight = 2.0 * double(count);  // QUELL_GRAM_LEAST_WEIGHT
  std::vector<Eigen::Index> varied;
  const double weight = sums(0, 0);
  if (near(weight, leastWeight, kWeightMargin)) fit.undecided = true;
  if (weight < leastWeight) return varied;
  for (Eigen::Index j = 1; j < count; ++j) {
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
  VariableRange range(inputs.gramList);
  for (const WindowTile& part : tiles)
    range.include(unpackTile(inputs.tiles, inputs.params, part.tile, inputs.gramList).range);
  GramWindow window(inputs.gramList);
  window.scaling = scalingOf(range);
  for (const WindowTile& part : tiles) {
    const GramTile tile = unpackTile(inputs.tiles, inputs.params, part.tile, inputs.gramList);
    if (tile.range.empty()) continue;
    const GramMatrix m = changeOfScaling(scalingOf(tile.range), window.scaling);
    window.sums += part.tent * m * tile.sums * m.transpose();
  }
  return window;
}

GramWindow windowOfPixels(const GramInputs& inputs, int number) {
  const std::vector<WindowTile> tiles = windowTiles(inputs.params, inputs.overlap, number);
  VariableRange range(inputs.list);
  for (const WindowTile& part : tiles)
    for (const BlockPixel pixel : tilePixels(inputs, part.tile))
      range.include(inputs.guides, pixel.x, pixel.y);
  GramWindow window(inputs.list);
  window.scaling = scalingOf(range);
  for (const WindowTile& part : tiles)
    for (const BlockPixel pixel : tilePixels(inputs, part.tile))
      addPixel(inputs, window.scaling, pixel, part.tent, window.sums);
  return window;
}

GramFit ridgeFit(const GramWindow& window, const FeatureNames& list, double noiseVariance) {
  GramFit fit;
  fit.record = FitRecord(list);
  fit.record.anchor = window.scaling.anchor;
  fit.record.scale = window.scaling.scale;
  const double weight = window.sums(0, 0);
  if (!(weight > 0.0)) return fit;
  const GramMatrix covariance = centred(window.sums);
  const std::vector<Eigen::Index> varied = variedFeatures(window.sums, covariance, fit);
  const Eigen::Index count = Eigen::Index(varied.size());
  Coefficients& coefficients = fit.record.coefficients;
  if (count > 0) {
    Matrix normal(count, count), right(count, QUELL_FIT_CHANNELS);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Index a = varied[std::size_t(i)];
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
  const Eigen::Index others = list.count() - 1;
  coefficients.row(0) = mean.row(0).tail<QUELL_FIT_CHANNELS>() -
                        mean.row(0).segment(1, others) * coefficients.bottomRows(others);
  return fit;
}

std::vector<GramFit> gramSolveOracle(const GramSolveInputs& inputs) {
  std::vector<GramFit> fits;
  for (int window = 0; window < gramTileCount(inputs.params); ++window)
    fits.push_back(ridgeFit(windowOfTiles(inputs, window), inputs.list, double(inputs.params.noiseVariance)));
  return fits;
}

}  // namespace quell::tests

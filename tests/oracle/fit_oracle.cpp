#include "tests/oracle/fit_oracle.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "host/stress/least_squares.hpp"
#include "kernels/accumulate_noisy_params.h"

namespace quell::tests {
namespace {

using Matrix = Eigen::MatrixXd;

// PCG-RXS-M-XS (Jarzynski and Olano 2020).
std::uint32_t hash(std::uint32_t v) {
  const std::uint32_t state = v * 747796405u + 2891336453u;
  const std::uint32_t word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

// Uniform in [-1, 1): the bits as a two's complement fraction.
double signedUnit(std::uint32_t bits) { return std::ldexp(double(std::int32_t(bits)), -31); }

// Reflections at the image's edges; an edge pixel is followed by itself.
int mirror(int i, int size) {
  while (i < 0 || i >= size) i = i < 0 ? -1 - i : 2 * size - 1 - i;
  return i;
}

double weightAt(const FitInputs& inputs, BlockPixel pixel) {
  return inputs.guides.at(QUELL_GUIDE_WEIGHT, pixel.x, pixel.y);
}

// Maps the unbounded variables of the block to [0, 1].
FitRecord blockScaling(const FitInputs& inputs, int block) {
  VariableRange range(inputs.list);
  for (int row = 0; row < QUELL_BLOCK_PIXELS; ++row) {
    const BlockPixel pixel = blockPixel(inputs.params, block, row);
    if (weightAt(inputs, pixel) > 0.0) range.include(inputs.guides, pixel.x, pixel.y);
  }
  return scalingOf(range);
}

// The augmented matrix [T + N, z], every row times the square root of its pixel's weight.
Matrix augmentedMatrix(const FitInputs& inputs, int block, const FitRecord& record) {
  const int count = inputs.list.count();
  Matrix matrix = Matrix::Zero(QUELL_BLOCK_PIXELS, count + QUELL_FIT_CHANNELS);
  const std::uint32_t seed = hash(inputs.params.noiseSeed + std::uint32_t(block));
  for (int row = 0; row < QUELL_BLOCK_PIXELS; ++row) {
    const BlockPixel pixel = blockPixel(inputs.params, block, row);
    const double rootWeight = std::sqrt(weightAt(inputs, pixel));
    if (rootWeight == 0.0) continue;
    const auto t = features(inputs.guides, record, pixel.x, pixel.y);
    for (int k = 0; k < count; ++k) {
      const std::uint32_t counter = std::uint32_t(row + k * QUELL_BLOCK_PIXELS) ^ seed;
      const double noise = k == 0 ? 0.0 : double(inputs.params.noiseAmplitude) * signedUnit(hash(counter));
      matrix(row, k) = (t[k] + noise) * rootWeight;
    }
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      matrix(row, count + c) = inputs.irradiance.at(c, pixel.x, pixel.y) * rootWeight;
  }
  return matrix;
}

// Columns that are no combination of those before them: only these get coefficients.
std::vector<Eigen::Index> independentColumns(const Matrix& matrix) {
  const double tolerance = matrix.col(0).squaredNorm() * double(QUELL_FIT_RANK_TOLERANCE);
  std::vector<Eigen::Index> columns;
  Matrix basis(matrix.rows(), 0);
  for (Eigen::Index k = 0; k < matrix.cols() - QUELL_FIT_CHANNELS; ++k) {
    Eigen::VectorXd residual = matrix.col(k);
    for (int pass = 0; pass < 2; ++pass) residual -= basis * (basis.transpose() * residual);
    if (!(residual.squaredNorm() > tolerance)) continue;
    columns.push_back(k);
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.col(basis.cols() - 1) = residual.normalized();
  }
  return columns;
}

// Least squares on the independent columns. Returns the condition of the triangular factor.
double solve(const Matrix& matrix, FitRecord& record) {
  const std::vector<Eigen::Index> columns = independentColumns(matrix);
  if (columns.empty()) return std::numeric_limits<double>::infinity();
  Matrix t(matrix.rows(), Eigen::Index(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) t.col(Eigen::Index(i)) = matrix.col(columns[i]);
  // These columns are independent: none is left out.
  const stress::LeastSquaresSolution solution =
      stress::leastSquares(t, matrix.rightCols<QUELL_FIT_CHANNELS>(), std::numeric_limits<double>::epsilon());
  for (std::size_t i = 0; i < columns.size(); ++i)
    record.coefficients.row(columns[i]) = solution.coefficients.row(Eigen::Index(i));
  const bool allTaken = Eigen::Index(columns.size()) == matrix.cols() - QUELL_FIT_CHANNELS;
  return allTaken ? solution.condition : std::numeric_limits<double>::infinity();
}

}  // namespace

BlockPixel blockPixel(const FitParams& params, int block, int row) {
  const int x = params.blockOffsetX + block % params.blocksX * QUELL_BLOCK_EDGE + row % QUELL_BLOCK_EDGE;
  const int y = params.blockOffsetY + block / params.blocksX * QUELL_BLOCK_EDGE + row / QUELL_BLOCK_EDGE;
  return {mirror(x, params.planes.width), mirror(y, params.planes.height)};
}

FitExact fitOracle(const FitInputs& inputs) {
  FitExact exact;
  for (int block = 0; block < inputs.params.blocksX * inputs.params.blocksY; ++block) {
    FitRecord record = blockScaling(inputs, block);
    exact.conditions.push_back(solve(augmentedMatrix(inputs, block, record), record));
    exact.records.push_back(record);
  }
  return exact;
}

}  // namespace quell::tests

#include "tests/oracle/fit_oracle.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

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

// Positions of the block are mapped from [anchor, anchor + 1 / scale] to [0, 1].
void scalePositions(const FitInputs& inputs, int block, FitRecord& record) {
  double low[3], high[3], centreSquared = 0.0;
  bool empty = true;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = std::numeric_limits<double>::max();
    high[axis] = -low[axis];
    for (int row = 0; row < QUELL_BLOCK_PIXELS; ++row) {
      const BlockPixel pixel = blockPixel(inputs.params, block, row);
      if (!(weightAt(inputs, pixel) > 0.0)) continue;
      const double p = inputs.guides.at(QUELL_GUIDE_POSITION + axis, pixel.x, pixel.y);
      low[axis] = std::min(low[axis], p);
      high[axis] = std::max(high[axis], p);
      empty = false;
    }
    const double centre = 0.5 * (low[axis] + high[axis]);
    centreSquared += centre * centre;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double range = high[axis] - low[axis];
    const bool significant = !empty && range > double(QUELL_FIT_LEAST_RANGE) * std::sqrt(centreSquared);
    record.anchor[axis] = empty ? 0.0 : low[axis];
    // Rounding noise is divided by the distance instead.
    const double otherwise = !empty && centreSquared > 0.0 ? std::sqrt(centreSquared) : 1.0;
    record.scale[axis] = 1.0 / (significant ? range : otherwise);
  }
}

// The augmented matrix [T + N, z], every row times the square root of its pixel's weight.
Matrix augmentedMatrix(const FitInputs& inputs, int block, const FitRecord& record) {
  Matrix matrix = Matrix::Zero(QUELL_BLOCK_PIXELS, QUELL_FIT_COLUMNS);
  const std::uint32_t seed = hash(inputs.params.noiseSeed + std::uint32_t(block));
  for (int row = 0; row < QUELL_BLOCK_PIXELS; ++row) {
    const BlockPixel pixel = blockPixel(inputs.params, block, row);
    const double rootWeight = std::sqrt(weightAt(inputs, pixel));
    if (rootWeight == 0.0) continue;
    const auto t = features(inputs.guides, record, pixel.x, pixel.y);
    for (int k = 0; k < QUELL_FEATURES; ++k) {
      const std::uint32_t counter = std::uint32_t(row + k * QUELL_BLOCK_PIXELS) ^ seed;
      const double noise = k == 0 ? 0.0 : double(inputs.params.noiseAmplitude) * signedUnit(hash(counter));
      matrix(row, k) = (t[k] + noise) * rootWeight;
    }
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      matrix(row, QUELL_FEATURES + c) = inputs.irradiance.at(c, pixel.x, pixel.y) * rootWeight;
  }
  return matrix;
}

// Columns that are no combination of those before them: only these get coefficients.
std::vector<int> independentColumns(const Matrix& matrix) {
  const double tolerance = matrix.col(0).squaredNorm() * double(QUELL_FIT_RANK_TOLERANCE);
  std::vector<int> columns;
  Matrix basis(matrix.rows(), 0);
  for (int k = 0; k < QUELL_FEATURES; ++k) {
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
  const std::vector<int> columns = independentColumns(matrix);
  if (columns.empty()) return std::numeric_limits<double>::infinity();
  Matrix t(matrix.rows(), Eigen::Index(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) t.col(Eigen::Index(i)) = matrix.col(columns[i]);
  const Eigen::ColPivHouseholderQR<Matrix> qr(t);
  const Matrix solution = qr.solve(matrix.rightCols<QUELL_FIT_CHANNELS>());
  for (std::size_t i = 0; i < columns.size(); ++i)
    record.coefficients.row(columns[i]) = solution.row(Eigen::Index(i));
  if (columns.size() < QUELL_FEATURES) return std::numeric_limits<double>::infinity();
  const auto diagonal = qr.matrixQR().diagonal().cwiseAbs();
  return diagonal.maxCoeff() / diagonal.minCoeff();
}

}  // namespace

BlockPixel blockPixel(const FitParams& params, int block, int row) {
  const int x = params.blockOffsetX + block % params.blocksX * QUELL_BLOCK_EDGE + row % QUELL_BLOCK_EDGE;
  const int y = params.blockOffsetY + block / params.blocksX * QUELL_BLOCK_EDGE + row / QUELL_BLOCK_EDGE;
  return {mirror(x, params.planes.width), mirror(y, params.planes.height)};
}

Eigen::Matrix<double, 1, QUELL_FEATURES> features(const Planes& guides, const FitRecord& record, int x,
                                                  int y) {
  Eigen::Matrix<double, 1, QUELL_FEATURES> t;
  t[0] = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double w = (guides.at(QUELL_GUIDE_POSITION + axis, x, y) - record.anchor[std::size_t(axis)]) *
                     record.scale[std::size_t(axis)];
    t[1 + axis] = guides.at(QUELL_GUIDE_NORMAL + axis, x, y);
    t[4 + axis] = w;
    t[7 + axis] = w * w;
  }
  return t;
}

FitExact fitOracle(const FitInputs& inputs) {
  FitExact exact;
  for (int block = 0; block < inputs.params.blocksX * inputs.params.blocksY; ++block) {
    FitRecord record;
    scalePositions(inputs, block, record);
    exact.conditions.push_back(solve(augmentedMatrix(inputs, block, record), record));
    exact.records.push_back(record);
  }
  return exact;
}

FitRecord unpackRecord(const Planes& records, int block) {
  const float* values = records.values.data() + std::size_t(block) * QUELL_FIT_RECORD;
  FitRecord record;
  for (int j = 0; j < QUELL_FEATURES; ++j)
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      record.coefficients(j, c) = values[j * QUELL_FIT_CHANNELS + c];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    record.anchor[axis] = values[QUELL_FIT_ANCHOR + axis];
    record.scale[axis] = values[QUELL_FIT_SCALE + axis];
  }
  return record;
}

Planes packRecords(const std::vector<FitRecord>& records) {
  Planes packed({int(records.size()) * QUELL_FIT_RECORD, 1}, 1);
  for (std::size_t block = 0; block < records.size(); ++block) {
    float* values = packed.values.data() + block * QUELL_FIT_RECORD;
    for (int j = 0; j < QUELL_FEATURES; ++j)
      for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
        values[j * QUELL_FIT_CHANNELS + c] = float(records[block].coefficients(j, c));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      values[QUELL_FIT_ANCHOR + axis] = float(records[block].anchor[axis]);
      values[QUELL_FIT_SCALE + axis] = float(records[block].scale[axis]);
    }
  }
  return packed;
}

}  // namespace quell::tests

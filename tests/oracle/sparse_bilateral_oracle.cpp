#include "tests/oracle/sparse_bilateral_oracle.hpp"

#include <cmath>

#include "kernels/common/guides.h"
#include "kernels/common/sunflower.h"
#include "kernels/sparse_bilateral_params.h"

namespace quell::tests {
namespace {

constexpr double kLeastSum = 1e-5;
constexpr double kPi = 3.14159265358979323846;

double radiusAt(const SparseBilateralInputs& inputs, int x, int y) {
  if (inputs.cellConfidence.count == 0) return inputs.radius;
  const double factor = inputs.cellConfidence.at(0, x / 16, y / 8) < 0.5f ? inputs.lowFactor : 1.0;
  return factor * inputs.radius * (1.0 - inputs.windowConfidence.at(0, x / 16, y / 8));
}

struct Sum {
  double value[3] = {};
  double weight = 0.0;
};

void add(Sum& sum, const SparseBilateralInputs& inputs, int x, int y, double weight) {
  for (int c = 0; c < 3; ++c) sum.value[c] += weight * inputs.irradiance.at(c, x, y);
  sum.weight += weight;
}

Sum filterPixel(const SparseBilateralInputs& inputs, int x, int y) {
  const Size size = inputs.irradiance.size();
  const EdgeStopsOracle stops(inputs.guides, inputs.stops, x, y);
  const auto weightAt = [&](int column, int row) {
    return double(inputs.guides.guides.at(QUELL_GUIDE_WEIGHT, column, row));
  };
  Sum sum;
  add(sum, inputs, x, y, weightAt(x, y));
  const auto taps = sparseTaps(radiusAt(inputs, x, y), inputs.frameIndex);
  for (std::size_t i = 0; i < taps.size(); ++i) {
    const auto [dx, dy] = taps[i];
    const int column = x + dx, row = y + dy;
    if ((dx == 0 && dy == 0) || column < 0 || row < 0 || column >= size.width || row >= size.height) continue;
    const double gaussian = std::exp(-2.0 * (double(i) + 0.5) / double(taps.size()));
    const double penalty = stops.surfacePenalty(column, row, std::hypot(dx, dy));
    add(sum, inputs, column, row, gaussian * weightAt(column, row) * weightOfPenalty(penalty));
  }
  return sum;
}

}  // namespace

std::vector<std::array<int, 2>> sparseTaps(double radius, std::uint32_t frameIndex) {
#define POINT(x, y) {x, y},
  static const std::vector<std::array<int, 2>> kPoints = {QUELL_SUNFLOWER(POINT)};
#undef POINT
  const double angle = 2.0 * kPi * frameIndex * (std::sqrt(5.0) - 1.0) / 2.0;
  const int cosine = int(std::lround(QUELL_SUNFLOWER_UNIT * std::cos(angle)));
  const int sine = int(std::lround(QUELL_SUNFLOWER_UNIT * std::sin(angle)));
  // Whole numbers as on the device, so that both round to the same pixels.
  const int steps = int(radius * QUELL_SPARSE_STEPS);
  const auto pixels = [&](int turned) {
    return int(std::lround(double(steps) * (turned / QUELL_SUNFLOWER_UNIT) /
                           (QUELL_SPARSE_STEPS * QUELL_SUNFLOWER_UNIT)));
  };
  std::vector<std::array<int, 2>> taps;
  for (const auto& [x, y] : kPoints)
    taps.push_back({pixels(cosine * x - sine * y), pixels(sine * x + cosine * y)});
  return taps;
}

SparseBilateralExact sparseBilateralOracle(const SparseBilateralInputs& inputs) {
  const Size size = inputs.irradiance.size();
  SparseBilateralExact exact{ExactPlanes(size, 3), BasicPlanes<char>(size, 1)};
  forEachPixel(size, [&](int x, int y) {
    const Sum sum = filterPixel(inputs, x, y);
    exact.undecided.at(0, x, y) = char(sum.weight > 0.0 && sum.weight < kLeastSum);
    if (sum.weight <= 0.0) return;
    for (int c = 0; c < 3; ++c) exact.irradiance.at(c, x, y) = sum.value[c] / sum.weight;
  });
  return exact;
}

}  // namespace quell::tests

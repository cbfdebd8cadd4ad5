#include "tests/oracle/separable_bilateral_oracle.hpp"

#include <cmath>
#include <cstdlib>

namespace quell::tests {
namespace {

constexpr double kLeastSum = 1e-5;
constexpr int kReach = 14;
constexpr double kLeastSigma = 1e-3;

double sigmaAt(const SeparableBilateralInputs& inputs, int x, int y) {
  const Planes& roughness = inputs.guides.roughness;
  return inputs.sigma * (roughness.count > 0 ? std::pow(roughness.at(0, x, y), 0.1) : 1.0) + kLeastSigma;
}

}  // namespace

SeparableBilateralExact separableBilateralOracle(const SeparableBilateralInputs& inputs) {
  const Size size = inputs.weights.size();
  SeparableBilateralExact exact{ExactPlanes(size, 3), BasicPlanes<char>(size, 1)};
  forEachPixel(size, [&](int x, int y) {
    const EdgeStopsOracle stops(inputs.guides, inputs.stops, x, y);
    const double sigma = sigmaAt(inputs, x, y);
    double sum[3] = {}, weightSum = 0.0;
    for (int tap = -kReach; tap <= kReach; ++tap) {
      const int column = inputs.alongRows ? x + tap : x, row = inputs.alongRows ? y : y + tap;
      if (column < 0 || row < 0 || column >= size.width || row >= size.height) continue;
      double penalty = tap * tap / (2.0 * sigma * sigma);
      if (tap != 0)
        penalty += stops.surfacePenalty(column, row, std::abs(tap)) + stops.roughnessPenalty(column, row);
      const double weight = weightOfPenalty(penalty) * inputs.weights.at(0, column, row);
      if (weight <= 0.0) continue;
      for (int c = 0; c < 3; ++c) sum[c] += weight * inputs.irradiance.at(c, column, row);
      weightSum += weight;
    }
    exact.undecided.at(0, x, y) = char(weightSum > 0.0 && weightSum < kLeastSum);
    if (weightSum <= 0.0) return;
    for (int c = 0; c < 3; ++c) exact.irradiance.at(c, x, y) = sum[c] / weightSum;
  });
  return exact;
}

}  // namespace quell::tests

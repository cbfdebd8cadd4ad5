#include "tests/oracle/atrous_oracle.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "kernels/common/guides.h"

namespace quell::tests {
namespace {

using Eigen::Vector3d;

// A smaller sum of weights than this is nothing but taps near the largest penalty, of which float knows too little.
constexpr double kLeastSum = 1e-5;

double splineWeight(int radius, int tap) {
  constexpr double kCubic[] = {3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0};
  constexpr double kLinear[] = {1.0 / 2.0, 1.0 / 4.0};
  return radius == 2 ? kCubic[std::abs(tap)] : kLinear[std::abs(tap)];
}

Vector3d irradianceAt(const AtrousInputs& inputs, int signal, int x, int y) {
  return {inputs.irradiance.at(3 * signal, x, y), inputs.irradiance.at(3 * signal + 1, x, y),
          inputs.irradiance.at(3 * signal + 2, x, y)};
}

double luminanceAt(const AtrousInputs& inputs, int signal, int x, int y) {
  if (inputs.stopLuminance.count > 0) return inputs.stopLuminance.at(signal, x, y);
  const Vector3d rgb = irradianceAt(inputs, signal, x, y);
  return luminanceOf(rgb[0], rgb[1], rgb[2]);
}

double sampleWeight(const AtrousInputs& inputs, int signal, int x, int y) {
  return inputs.guides.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y);
}

// 3x3 binomial; outside the image stands the centre.
double prefilteredVariance(const AtrousInputs& inputs, int signal, int x, int y) {
  const Size size = inputs.variance.size();
  double sum = 0.0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const bool inside = x + dx >= 0 && x + dx < size.width && y + dy >= 0 && y + dy < size.height;
      const double weight = (2 - std::abs(dx)) * (2 - std::abs(dy)) / 16.0;
      sum += weight * inputs.variance.at(signal, inside ? x + dx : x, inside ? y + dy : y);
    }
  }
  return sum;
}

// From 1 at sharpRoughness to 2 at roughness 0.
double sharpening(const AtrousInputs& inputs, int signal, int x, int y) {
  if (inputs.sharpRoughness == 0.0 || inputs.guides.roughness.count == 0) return 1.0;
  if (signal != inputs.signals() - 1) return 1.0;
  return 2.0 - std::min(inputs.guides.roughness.at(0, x, y) / inputs.sharpRoughness, 1.0);
}

// Penalty per unit of luminance; none where the centre has no sample to compare with.
double luminancePenaltyRate(const AtrousInputs& inputs, int signal, int x, int y) {
  if (sampleWeight(inputs, signal, x, y) == 0.0) return 0.0;
  const bool guided = inputs.variance.count > 0;
  const double deviation = guided ? std::sqrt(prefilteredVariance(inputs, signal, x, y)) : 1.0;
  return sharpening(inputs, signal, x, y) / (inputs.luminanceSigma * deviation + QUELL_LEAST_LUMINANCE_STEP);
}

struct Filtered {
  Vector3d irradiance = Vector3d::Zero();
  double variance = 0.0;
  double weight = 0.0;
};

void add(Filtered& sum, const AtrousInputs& inputs, int signal, int x, int y, double weight) {
  const Vector3d irradiance = irradianceAt(inputs, signal, x, y);
  sum.irradiance += weight * irradiance;
  sum.weight += weight;
  if (inputs.variance.count > 0) sum.variance += weight * weight * inputs.variance.at(signal, x, y);
}

Filtered filterPixel(const AtrousInputs& inputs, const EdgeStopsOracle& stops, int signal, int x, int y) {
  const Size size = inputs.irradiance.size();
  const double luminance = luminanceAt(inputs, signal, x, y);
  const double rate = luminancePenaltyRate(inputs, signal, x, y);
  Filtered sum;
  for (int tapY = -inputs.radius; tapY <= inputs.radius; ++tapY) {
    for (int tapX = -inputs.radius; tapX <= inputs.radius; ++tapX) {
      const int column = x + tapX * inputs.step, row = y + tapY * inputs.step;
      if (!inputs.corners && std::abs(tapX * tapY) == inputs.radius * inputs.radius) continue;
      if (column < 0 || column >= size.width || row < 0 || row >= size.height) continue;
      double penalty = 0.0;  // the centre resembles itself
      if (tapX != 0 || tapY != 0) {
        const double step = rate * std::abs(luminanceAt(inputs, signal, column, row) - luminance);
        penalty = stops.surfacePenalty(column, row, inputs.step * std::hypot(tapX, tapY)) +
                  (inputs.stopLuminance.count > 0 ? step * step : step);
        if (signal == inputs.signals() - 1) penalty += stops.roughnessPenalty(column, row);
      }
      const double spline = splineWeight(inputs.radius, tapX) * splineWeight(inputs.radius, tapY);
      const double weight = spline * weightOfPenalty(penalty) * sampleWeight(inputs, signal, column, row);
      if (weight > 0.0) add(sum, inputs, signal, column, row, weight);
    }
  }
  return sum;
}

void store(AtrousExact& exact, const Filtered& sum, bool guided, int signal, int x, int y) {
  for (int c = 0; c < 3; ++c) exact.irradiance.at(3 * signal + c, x, y) = sum.irradiance[c] / sum.weight;
  if (!guided) return;
  exact.variance.at(signal, x, y) = sum.variance / (sum.weight * sum.weight);
}

}  // namespace

AtrousExact atrousOracle(const AtrousInputs& inputs) {
  const Size size = inputs.irradiance.size();
  AtrousExact exact{ExactPlanes(size, inputs.irradiance.count), ExactPlanes(size, inputs.variance.count),
                    BasicPlanes<char>(size, 1)};
  forEachPixel(size, [&](int x, int y) {
    const EdgeStopsOracle stops(inputs.guides, inputs.stops, x, y);
    for (int signal = 0; signal < inputs.signals(); ++signal) {
      const Filtered sum = filterPixel(inputs, stops, signal, x, y);
      exact.undecided.at(0, x, y) |= char(sum.weight > 0.0 && sum.weight < kLeastSum);
      if (sum.weight > 0.0) store(exact, sum, inputs.variance.count > 0, signal, x, y);
    }
  });
  return exact;
}

}  // namespace quell::tests

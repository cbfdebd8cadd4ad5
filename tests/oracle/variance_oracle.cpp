#include "tests/oracle/variance_oracle.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/common/guides.h"
#include "tests/oracle/firefly_oracle.hpp"

namespace quell::tests {
namespace {

struct Moments {
  double first = 0.0;
  double second = 0.0;
};

Moments momentsAt(const VarianceInputs& inputs, int signal, int x, int y) {
  const int plane = QUELL_MOMENT_PLANES * signal;
  return {inputs.moments.at(plane + QUELL_MOMENT_FIRST, x, y),
          inputs.moments.at(plane + QUELL_MOMENT_SECOND, x, y)};
}

// Bilateral mean of the moments over 7x7 pixels, as far as they lie in the image.
Moments spatialMoments(const VarianceInputs& inputs, int signal, int x, int y) {
  const EdgeStopsOracle stops(inputs.guides, inputs.stops, x, y);
  const Size size = inputs.moments.size();
  Moments sum;
  double weights = 0.0;
  for (int row = std::max(0, y - 3); row <= std::min(size.height - 1, y + 3); ++row) {
    for (int column = std::max(0, x - 3); column <= std::min(size.width - 1, x + 3); ++column) {
      const bool centre = row == y && column == x;
      const double distance = std::hypot(column - x, row - y);
      const double bilateral = weightOfPenalty(stops.surfacePenalty(column, row, centre ? 1.0 : distance));
      const double weight = bilateral * inputs.guides.guides.at(QUELL_GUIDE_WEIGHT + signal, column, row);
      const Moments tap = momentsAt(inputs, signal, column, row);
      sum.first += weight * tap.first;
      sum.second += weight * tap.second;
      weights += weight;
    }
  }
  if (weights == 0.0) return {};
  return {sum.first / weights, sum.second / weights};
}

// Independent samples that the mean over a history is worth.
double samplesBehind(const VarianceInputs& inputs, double length) {
  return inputs.ofMean ? std::max(length, 1.0) : 1.0;
}

// Over 3x3 pixels of the image with binomial weights, of what has a sample.
double prefilteredLuminance(const VarianceInputs& inputs, int signal, int x, int y) {
  const Size size = inputs.irradiance.size();
  double sum = 0.0, weights = 0.0;
  for (int row = std::max(0, y - 1); row <= std::min(size.height - 1, y + 1); ++row) {
    for (int column = std::max(0, x - 1); column <= std::min(size.width - 1, x + 1); ++column) {
      const double weight = (2 - std::abs(column - x)) * (2 - std::abs(row - y)) *
                            double(inputs.guides.guides.at(QUELL_GUIDE_WEIGHT + signal, column, row));
      sum += weight * luminanceAt(inputs.irradiance, signal, column, row);
      weights += weight;
    }
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

// Whether one sample may make the light of a pixel: most of what n samples could have at most in their second moment is
// there, or lately the pixel has had far less than its history holds.
bool isSuspect(const VarianceInputs& inputs, int signal, int x, int y) {
  const double length = inputs.historyLength.at(signal, x, y);
  const double samples = std::min(length, 1.0 / inputs.momentsLeastWeight);
  const Moments moments = momentsAt(inputs, signal, x, y);
  const bool oneSample = moments.second > 0.7 * samples * moments.first * moments.first;
  const bool faded = luminanceAt(inputs.irradiance, signal, x, y) > inputs.fireflyRatio * moments.first;
  return length >= 4.0 && (oneSample || faded);
}

double tapWeight(const VarianceInputs& inputs, int signal, int x, int y) {
  const Planes& guides = inputs.guides.guides;
  const double share = isSuspect(inputs, signal, x, y)
                           ? fireflyShare(inputs.irradiance, guides, inputs.fireflyRatio, signal, x, y)
                           : 1.0;
  return share * guides.at(QUELL_GUIDE_WEIGHT + signal, x, y);
}

}  // namespace

VarianceExact varianceOracle(const VarianceInputs& inputs) {
  const Size size = inputs.moments.size();
  const int signals = inputs.historyLength.count;
  VarianceExact exact{ExactPlanes(size, signals), ExactPlanes(size, signals), ExactPlanes(size, signals),
                      ExactPlanes(size, signals)};
  for (int signal = 0; signal < signals; ++signal) {
    forEachPixel(size, [&](int x, int y) {
      if (inputs.irradiance.count > 0) {
        exact.stopLuminance.at(signal, x, y) = prefilteredLuminance(inputs, signal, x, y);
        exact.tapWeights.at(signal, x, y) = tapWeight(inputs, signal, x, y);
      }
      const double length = inputs.historyLength.at(signal, x, y);
      const bool hasSample = inputs.guides.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y) > 0.0f;
      const bool spatial = length < inputs.temporalFrames && hasSample;
      const Moments moments =
          spatial ? spatialMoments(inputs, signal, x, y) : momentsAt(inputs, signal, x, y);
      const double raise =
          (spatial ? inputs.temporalFrames / std::max(length, 1.0) : 1.0) / samplesBehind(inputs, length);
      exact.variance.at(signal, x, y) = raise * std::max(moments.second - moments.first * moments.first, 0.0);
      exact.magnitude.at(signal, x, y) = raise * std::max(moments.second, moments.first * moments.first);
    });
  }
  return exact;
}

}  // namespace quell::tests

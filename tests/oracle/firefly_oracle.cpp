#include "tests/oracle/firefly_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "kernels/common/guides.h"
#include "tests/oracle/edge_stops_oracle.hpp"

namespace quell::tests {
namespace {

constexpr int kRing = 3;          // pixels
constexpr int kLeastHistory = 4;  // frames
constexpr double kLeastShare = 1e-12;

bool isInside(Size size, int x, int y) { return x >= 0 && y >= 0 && x < size.width && y < size.height; }

// Of the pixels with a sample at this distance along the larger of the axes; -1 if there are none.
double brightestAround(const Planes& irradiance, const Planes& guides, int signal, int x, int y) {
  double brightest = -1.0;
  for (int dy = -kRing; dy <= kRing; ++dy) {
    for (int dx = -kRing; dx <= kRing; ++dx) {
      if (std::max(std::abs(dx), std::abs(dy)) != kRing) continue;
      if (!isInside(irradiance.size(), x + dx, y + dy)) continue;
      if (guides.at(QUELL_GUIDE_WEIGHT + signal, x + dx, y + dy) == 0.0f) continue;
      brightest = std::max(brightest, luminanceAt(irradiance, signal, x + dx, y + dy));
    }
  }
  return brightest;
}

}  // namespace

double luminanceAt(const Planes& irradiance, int signal, int x, int y) {
  const auto channel = [&](int c) { return double(irradiance.at(3 * signal + c, x, y)); };
  return luminanceOf(channel(0), channel(1), channel(2));
}

double fireflyShare(const Planes& irradiance, const Planes& guides, double ratio, int signal, int x, int y) {
  const double here = luminanceAt(irradiance, signal, x, y);
  const double brightest = brightestAround(irradiance, guides, signal, x, y);
  if (brightest < 0.0 || here <= ratio * brightest) return 1.0;
  return std::max(std::pow(brightest / here, 2.0), kLeastShare);
}

ExactPlanes fireflyWeightsOracle(const FireflyWeightsInputs& inputs) {
  const int signals = inputs.historyLength.count;
  ExactPlanes weights(inputs.irradiance.size(), signals);
  for (int signal = 0; signal < signals; ++signal) {
    forEachPixel(weights.size(), [&](int x, int y) {
      const bool suspect = inputs.historyLength.at(signal, x, y) >= kLeastHistory;
      const double share =
          suspect ? fireflyShare(inputs.irradiance, inputs.guides, inputs.ratio, signal, x, y) : 1.0;
      weights.at(signal, x, y) = share * inputs.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y);
    });
  }
  return weights;
}

}  // namespace quell::tests

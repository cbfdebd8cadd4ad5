// Double-precision oracle of kernels/common/fireflies.h, and of the stage firefly_weights, which does nothing else.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

struct FireflyWeightsInputs {
  Planes irradiance;     ///< 3 planes a signal
  Planes historyLength;  ///< 1 plane a signal
  Planes guides;         ///< of accumulate_noisy
  double ratio = 4.0;    ///< of a firefly's luminance to that of the brightest pixel of the ring
};

/// Of one pixel; `irradiance` has 3 planes a signal.
double luminanceAt(const Planes& irradiance, int signal, int x, int y);

/// Share of its weight that is left to a pixel whose light may come from one sample.
double fireflyShare(const Planes& irradiance, const Planes& guides, double ratio, int signal, int x, int y);

/// Weights of pixels as filter taps, 1 plane a signal.
ExactPlanes fireflyWeightsOracle(const FireflyWeightsInputs& inputs);

}  // namespace quell::tests

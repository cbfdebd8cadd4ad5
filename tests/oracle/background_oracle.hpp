// Double-precision oracle of the stage background, see kernels/background.cl.
#pragma once

#include "host/io/image.hpp"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct BackgroundInputs {
  io::Image radiance;  ///< linear, emission included, 3 channels
  io::Image emission;  ///< linear, 3 channels
};

struct BackgroundExact {
  ExactPlanes linear;   ///< 3 planes
  ExactPlanes encoded;  ///< 3 planes
};

/// What every pixel would be as background: radiance without emission, not below 0, plus emission; where a component of
/// either is broken, what is left is the emission, and nothing where it is that.
BackgroundExact backgroundOracle(const BackgroundInputs& inputs);

}  // namespace quell::tests

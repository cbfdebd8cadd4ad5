// Double-precision oracle of the stage light_gain, see kernels/light_gain.cl; and what becomes of its gains.
#pragma once

#include "kernels/light_params.h"
#include "tests/oracle/tiles_oracle.hpp"

namespace quell::tests {

struct LightGainInputs {
  Planes sums;  ///< records of light_sums
  Size size;    ///< of the image
  int signals = 1;
};

/// Signal by signal, row by row, as the device stores them.
struct LightGainExact {
  ExactPlanes gains;
  ExactPlanes
      magnitudes;  ///< as if no tile's loss made up for another's: rounding errors are relative to that
};

LightGainExact lightGainOracle(const LightGainInputs& inputs);

/// What a pixel of this luminance is multiplied by.
double lightRatio(double gain, double luminance);

}  // namespace quell::tests

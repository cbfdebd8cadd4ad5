// Double-precision oracle of the stage light_sums, see kernels/light_sums.cl.
#pragma once

#include "kernels/light_params.h"
#include "tests/oracle/tiles_oracle.hpp"

namespace quell::tests {

struct LightSumsInputs {
  Planes stopLuminance;  ///< of variance, 1 plane a signal
  Planes filtered;       ///< 3 planes a signal
  Planes guides;         ///< of accumulate_noisy

  int signals() const { return stopLuminance.count; }
};

/// Records as the device stores them: signal by signal, row by row, QUELL_LIGHT_RECORD numbers a tile.
struct LightSumsExact {
  ExactPlanes sums;
  ExactPlanes magnitudes;  ///< of what was added: rounding errors are relative to that
};

LightSumsExact lightSumsOracle(const LightSumsInputs& inputs);

}  // namespace quell::tests

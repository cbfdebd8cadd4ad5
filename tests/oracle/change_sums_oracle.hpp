// Double-precision oracle of the stage change_sums, see kernels/change_sums.cl.
#pragma once

#include "kernels/change_params.h"
#include "tests/oracle/tiles_oracle.hpp"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct ChangeSumsInputs {
  Planes innovation;     ///< QUELL_INNOVATION_PLANES a signal
  Planes historyLength;  ///< 1 plane a signal
  Planes sumsPrev;       ///< records as the device stores them
  double sumsKept = 0.0;

  int signals() const { return historyLength.count; }
};

/// Records as the device stores them: signal by signal, row by row, QUELL_CHANGE_RECORD numbers a tile.
struct ChangeSumsExact {
  ExactPlanes sums;
  ExactPlanes magnitudes;  ///< of what was added: rounding errors are relative to that
};

ChangeSumsExact changeSumsOracle(const ChangeSumsInputs& inputs);

}  // namespace quell::tests

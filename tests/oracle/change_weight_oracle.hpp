// Double-precision oracle of the stage change_weight, see kernels/change_weight.cl.
#pragma once

#include "kernels/change_params.h"
#include "tests/oracle/change_sums_oracle.hpp"

namespace quell::tests {

struct ChangeWeightInputs {
  Planes sums;              ///< records of change_sums
  Planes recentChangePrev;  ///< one value a tile
  Size size;                ///< of the image
  int signals = 1;
  bool restarted = false;  ///< no frame before
  double threshold = 2.0;
  double recentChangeThreshold = 1.0;
  double gain = 4.0;
  double mostWeight = 1.0;
};

/// Signal by signal, row by row, as the device stores them.
struct ChangeWeightExact {
  ExactPlanes weights;
  ExactPlanes recentChange;
};

ChangeWeightExact changeWeightOracle(const ChangeWeightInputs& inputs);

}  // namespace quell::tests

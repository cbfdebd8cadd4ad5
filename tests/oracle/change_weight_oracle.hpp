// Double-precision oracle of the stage change_weight, see kernels/change_weight.cl.
#pragma once

#include "kernels/change_params.h"
#include "tests/oracle/change_sums_oracle.hpp"

namespace quell::tests {

struct ChangeWeightInputs {
  Planes sums;  ///< records of change_sums
  Size size;    ///< of the image
  int signals = 1;
  double threshold = 2.0;
  double gain = 4.0;
  double mostWeight = 1.0;
};

/// Signal by signal, row by row, as the device stores them.
ExactPlanes changeWeightOracle(const ChangeWeightInputs& inputs);

}  // namespace quell::tests

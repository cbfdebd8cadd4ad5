// Double-precision oracle of the stage follow_change, see kernels/follow_change.cl.
#pragma once

#include "kernels/accumulate_noisy_params.h"
#include "tests/oracle/change_sums_oracle.hpp"

namespace quell::tests {

struct FollowChangeInputs {
  Planes weights;           ///< of change_weight, signal by signal, row by row
  Planes newestIrradiance;  ///< 3 planes a signal; -1 where there is no sample
  Planes irradiance;        ///< 3 planes a signal
  Planes moments;           ///< 2 planes a signal
  Planes historyLength;     ///< 1 plane a signal
  double leastWeight = 0.2;
  double momentsLeastWeight = 0.2;

  int signals() const { return historyLength.count; }
};

struct FollowChangeExact {
  ExactPlanes irradiance, moments, historyLength;  ///< as in the inputs
  BasicPlanes<char> touched;    ///< 1 plane a signal: the newest sample deserves more than it got
  BasicPlanes<char> undecided;  ///< 1 plane: float and double may decide differently
};

FollowChangeExact followChangeOracle(const FollowChangeInputs& inputs);

}  // namespace quell::tests

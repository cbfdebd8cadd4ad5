// Double-precision oracle of the stage separable_bilateral (Mara et al. 2017, stages 9 and 10), see
// kernels/separable_bilateral.cl.
#pragma once

#include "tests/oracle/edge_stops_oracle.hpp"

namespace quell::tests {

struct SeparableBilateralInputs {
  Planes irradiance;  ///< 3 planes, of one signal
  Planes weights;     ///< 1 plane, of that signal
  FilterGuides guides;
  EdgeStopParams stops{};
  double sigma = 7.0;  ///< pixels
  bool alongRows = false;
};

struct SeparableBilateralExact {
  ExactPlanes irradiance;
  BasicPlanes<char>
      undecided;  ///< nothing but taps near the largest penalty, of which float knows too little
};

SeparableBilateralExact separableBilateralOracle(const SeparableBilateralInputs& inputs);

}  // namespace quell::tests

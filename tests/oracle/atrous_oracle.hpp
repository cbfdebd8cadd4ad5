// Double-precision oracle of the stage atrous (Dammertz et al. 2010; Schied et al. 2017), see kernels/atrous.cl.
#pragma once

#include "kernels/atrous_params.h"
#include "tests/oracle/edge_stops_oracle.hpp"

namespace quell::tests {

struct AtrousInputs {
  Planes irradiance;  ///< 3 planes a signal
  Planes variance;    ///< 1 plane a signal; empty: none
  Planes
      stopLuminance;  ///< 1 plane a signal, which stops compare by a squared penalty; empty: that of irradiance
  FilterGuides guides;
  EdgeStopParams stops{};
  double luminanceSigma = 4.0;
  int step = 1;
  int radius = 2;               ///< 2: 5x5 taps of a B3 spline, 1: 3x3 of a linear one
  bool corners = true;          ///< false: without the four corners of these
  double sharpRoughness = 0.0;  ///< below it the last signal's stop on luminance narrows; 0: nowhere

  int signals() const { return irradiance.count / 3; }
};

struct AtrousExact {
  ExactPlanes irradiance;
  ExactPlanes variance;
  BasicPlanes<char> undecided;  ///< nothing but taps near the largest penalty: float and double may disagree
};

AtrousExact atrousOracle(const AtrousInputs& inputs);

}  // namespace quell::tests

// Double-precision oracle of the stage variance (Schied et al. 2017, section 4.2), see kernels/variance.cl.
#pragma once

#include "kernels/variance_params.h"
#include "tests/oracle/edge_stops_oracle.hpp"

namespace quell::tests {

struct VarianceInputs {
  Planes moments;        ///< 2 planes a signal
  Planes historyLength;  ///< 1 plane a signal
  Planes irradiance;     ///< 3 planes a signal; empty: neither luminance for stops nor weights are asked for
  FilterGuides guides;
  EdgeStopParams stops{};
  int temporalFrames = 4;
  double fireflyRatio = 4.0;
  double momentsLeastWeight = 0.2;
  bool ofMean = false;  ///< variance of the mean over the history, else of its samples
};

struct VarianceExact {
  ExactPlanes variance;   ///< 1 plane a signal
  ExactPlanes magnitude;  ///< of the second moment: what rounding errors are relative to; 1 plane a signal
  ExactPlanes stopLuminance;  ///< 1 plane a signal; 0 without irradiance
  ExactPlanes tapWeights;     ///< 1 plane a signal; 0 without irradiance
};

VarianceExact varianceOracle(const VarianceInputs& inputs);

}  // namespace quell::tests

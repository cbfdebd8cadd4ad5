// Double-precision oracle of the stage accumulate_noisy (Koskela et al. 2019, phase I), see
// kernels/accumulate_noisy.cl.
#pragma once

#include "kernels/accumulate_noisy_params.h"
#include "tests/oracle/demodulation_oracle.hpp"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct AccumulateNoisyInputs {
  MaterialImages material;
  io::Image normal;
  io::Image position;  ///< world positions, or view depth
  bool positionIsDepth = false;
  Planes irradiancePrev;     ///< 3 planes
  Planes historyLengthPrev;  ///< 1 plane
  Planes guidesPrev;         ///< 7 planes
  ReprojectionParams reprojection{};
  double leastWeight = 0.2;
};

template <class Value>
struct AccumulateNoisyOutputs {
  BasicPlanes<Value> irradiance, historyLength, guides, pixelPrev, reprojectionMask;
};

struct AccumulateNoisyExact {
  AccumulateNoisyOutputs<double> outputs;  ///< pixelPrev before it is rounded to 1/256 pixel
  BasicPlanes<char> undecided;             ///< pixels on which float and double may decide differently
};

/// `pixelPrev` is what the device found, rounded to 1/256 pixel: rounding may fall either way, so the oracle
/// blends from there, and the test compares it with the unrounded one.
AccumulateNoisyExact accumulateNoisyOracle(const AccumulateNoisyInputs& inputs, const Planes& pixelPrev);

}  // namespace quell::tests

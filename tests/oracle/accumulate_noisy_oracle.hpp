// Double-precision oracle of the stage accumulate_noisy (Koskela et al. 2019, phase I; moments: Schied et al. 2017),
// see kernels/accumulate_noisy.cl.
#pragma once

#include "kernels/accumulate_noisy_params.h"
#include "tests/oracle/surface_oracle.hpp"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct AccumulateNoisyInputs : FrameImages {
  Planes irradiancePrev;     ///< 3 planes a signal
  Planes historyLengthPrev;  ///< 1 plane a signal
  Planes guidesPrev;         ///< 7 planes, with two signals 8
  Planes momentsPrev;        ///< 2 planes a signal; used only where moments are asked for
  io::Image motion;          ///< 2 channels; empty: absent
  io::Image objectId;        ///< the bits, as whole numbers; empty: absent
  Planes objectIdsPrev;      ///< 1 plane; used only with objectId
  double leastWeight = 0.2;
  int mostFrames = 255;             ///< longest history
  int mostFramesStill = 255;        ///< the same of pixels that do not move on the screen
  double momentsLeastWeight = 0.0;  ///< 0: no moments
};

template <class Value>
struct AccumulateNoisyOutputs {
  BasicPlanes<Value> irradiance, historyLength, guides, pixelPrev, reprojectionMask;
  BasicPlanes<Value> moments, viewDepth, roughness, objectIds;  ///< empty where there are none
  BasicPlanes<Value> newestIrradiance;                          ///< likewise; as irradiance
  BasicPlanes<Value> innovation;  ///< likewise; QUELL_INNOVATION_PLANES a signal
};

struct AccumulateNoisyExact {
  AccumulateNoisyOutputs<double> outputs;  ///< pixelPrev before it is rounded to 1/256 pixel
  BasicPlanes<char> undecided;             ///< pixels on which float and double may decide differently
};

/// `pixelPrev` is what the device found, rounded to 1/256 pixel: rounding may fall either way, so the oracle
/// blends from there, and the test compares it with the unrounded one.
AccumulateNoisyExact accumulateNoisyOracle(const AccumulateNoisyInputs& inputs, const Planes& pixelPrev);

}  // namespace quell::tests

// Host side of the stage light_gain.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/light_params.hpp"
#include "kernels/light_gain_ports.h"

namespace quell {

QUELL_OPTIONS(LightGainOptions, LIGHT_GAIN, "light_gain")

/// See kernels/light_gain.cl for what it computes and from what.
class LightGain : public KernelStage<LightGainOptions, LightParams> {
 public:
  explicit LightGain(const Configuration& configuration);

 protected:
  LightParams params(const FrameRun& run) const override { return makeLightParams(run); }
  std::array<std::size_t, 2> range(const FrameRun& run) const override { return tileRange(run.frame.size); }
};

}  // namespace quell

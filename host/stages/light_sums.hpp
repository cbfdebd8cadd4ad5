// Host side of the stage light_sums.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/light_params.hpp"
#include "kernels/light_sums_ports.h"

namespace quell {

QUELL_OPTIONS(LightSumsOptions, LIGHT_SUMS, "light_sums")

/// See kernels/light_sums.cl for what it computes and from what.
class LightSums : public KernelStage<LightSumsOptions, LightParams> {
 public:
  explicit LightSums(const Configuration& configuration);

 protected:
  LightParams params(const FrameRun& run) const override { return makeLightParams(run); }
  std::array<std::size_t, 2> range(const FrameRun& run) const override { return tileRange(run.frame.size); }
};

}  // namespace quell

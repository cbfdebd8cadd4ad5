// Host side of the stage change_weight.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/change_detection.hpp"
#include "kernels/change_weight_ports.h"

namespace quell {

QUELL_OPTIONS(ChangeWeightOptions, CHANGE_WEIGHT, "change_weight")

/// See kernels/change_weight.cl for what it computes, from what and after which paper.
class ChangeWeight : public KernelStage<ChangeWeightOptions, ChangeParams> {
 public:
  ChangeWeight(const Configuration& configuration, const ChangeDetection& detection);

 protected:
  ChangeParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override { return tileRange(run.frame.size); }

 private:
  ChangeDetection m_detection;
};

}  // namespace quell

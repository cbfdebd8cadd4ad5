// Host side of the stage guided_evaluate.
#pragma once

#include "host/stages/guided_grid.hpp"
#include "kernels/guided_evaluate_ports.h"

namespace quell {

QUELL_OPTIONS(GuidedEvaluateOptions, GUIDED_EVALUATE, "guided_evaluate")

/// See kernels/guided_evaluate.cl for what it computes, from what and after which paper.
class GuidedEvaluate : public KernelStage<GuidedEvaluateOptions, GuidedParams> {
 public:
  /// `subsampling`: edge of a cell, pixels; `skip`: leaves out background.
  GuidedEvaluate(const Configuration& configuration, int subsampling, bool skip);

 protected:
  GuidedParams params(const FrameRun& run) const override;
};

}  // namespace quell

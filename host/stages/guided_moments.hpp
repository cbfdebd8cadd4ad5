// Host side of the stage guided_moments.
#pragma once

#include "host/stages/guided_grid.hpp"
#include "kernels/guided_moments_ports.h"

namespace quell {

QUELL_OPTIONS(GuidedMomentsOptions, GUIDED_MOMENTS, "guided_moments")

/// See kernels/guided_moments.cl for what it computes, from what and after which paper.
class GuidedMoments : public KernelStage<GuidedMomentsOptions, GuidedParams> {
 public:
  /// `subsampling`: edge of a cell, 1, 2, 4 or 8 pixels; `tapWeights`: weights of the stage firefly_weights; `skip`: leaves
  /// out background.
  GuidedMoments(const Configuration& configuration, int subsampling, bool tapWeights, bool skip);

 protected:
  GuidedParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override;
};

}  // namespace quell

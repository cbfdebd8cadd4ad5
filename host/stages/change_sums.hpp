// Host side of the stage change_sums.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/change_detection.hpp"
#include "kernels/change_sums_ports.h"

namespace quell {

QUELL_OPTIONS(ChangeSumsOptions, CHANGE_SUMS, "change_sums")

/// See kernels/change_sums.cl for what it computes, from what and after which paper.
class ChangeSums : public KernelStage<ChangeSumsOptions, ChangeParams> {
 public:
  ChangeSums(const Configuration& configuration, const ChangeDetection& detection);

 protected:
  ChangeParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override { return tileRange(run.frame.size); }

 private:
  ChangeDetection m_detection;
};

}  // namespace quell

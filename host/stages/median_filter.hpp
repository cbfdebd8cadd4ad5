// Host side of the stage median_filter.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/median_filter_ports.h"

namespace quell {

QUELL_OPTIONS(MedianFilterOptions, MEDIAN_FILTER, "median_filter")

/// See kernels/median_filter.cl for what it computes, from what and after which paper.
class MedianFilter : public KernelStage<MedianFilterOptions, MedianFilterParams> {
 public:
  /// `skip`: leaves out background.
  MedianFilter(const Configuration& configuration, bool skip);

 protected:
  MedianFilterParams params(const FrameRun& run) const override;
};

}  // namespace quell

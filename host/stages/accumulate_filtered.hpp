// Host side of the stage accumulate_filtered.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/accumulate_filtered_ports.h"

namespace quell {

QUELL_OPTIONS(AccumulateFilteredOptions, ACCUMULATE_FILTERED, "accumulate_filtered")

/// See kernels/accumulate_filtered.cl for what it computes, from what and after which paper.
class AccumulateFiltered : public KernelStage<AccumulateFilteredOptions, AccumulateFilteredParams> {
 public:
  /// `leastWeight`: least weight of the newest filtered frame, (0, 1]; `skip`: leaves out background.
  AccumulateFiltered(const Configuration& configuration, double leastWeight, bool skip);

 protected:
  AccumulateFilteredParams params(const FrameRun& run) const override;

 private:
  double m_leastWeight;
};

}  // namespace quell

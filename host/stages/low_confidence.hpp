// Host side of the stage low_confidence.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/low_confidence_ports.h"

namespace quell {

QUELL_OPTIONS(LowConfidenceOptions, LOW_CONFIDENCE, "low_confidence")

/// See kernels/low_confidence.cl for what it computes, from what and after which paper.
class LowConfidence : public KernelStage<LowConfidenceOptions, LowConfidenceParams> {
 public:
  explicit LowConfidence(const Configuration& configuration);

 protected:
  LowConfidenceParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override;
};

}  // namespace quell

// Host side of the stage temporal_antialiasing.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/temporal_antialiasing_ports.h"

namespace quell {

QUELL_OPTIONS(TemporalAntialiasingOptions, TEMPORAL_ANTIALIASING, "temporal_antialiasing")

/// See kernels/temporal_antialiasing.cl for what it computes, from what and after which paper.
class TemporalAntialiasing : public KernelStage<TemporalAntialiasingOptions, TemporalAntialiasingParams> {
 public:
  /// `newestWeight`: weight of the newest frame, (0, 1]; `skip`: leaves background to the stage background, unless rays
  /// are jittered.
  TemporalAntialiasing(const Configuration& configuration, double newestWeight, bool skip);
  Coverage coverage(const Frame& frame) const override;

 protected:
  TemporalAntialiasingParams params(const FrameRun& run) const override;

 private:
  double m_newestWeight;
};

}  // namespace quell

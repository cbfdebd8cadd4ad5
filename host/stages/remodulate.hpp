// Host side of the stage remodulate.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/remodulate_ports.h"

namespace quell {

QUELL_OPTIONS(RemodulateOptions, REMODULATE, "remodulate")

/// See kernels/remodulate.cl for what it computes, from what and after which paper.
class Remodulate : public KernelStage<RemodulateOptions, RemodulateParams> {
 public:
  /// `writePlanes`: whether a later stage reads the display-encoded radiance, else it is the caller's if he wants it;
  /// `skip`: leaves background to the stage background.
  Remodulate(const Configuration& configuration, bool writePlanes, bool skip);

 protected:
  RemodulateParams params(const FrameRun& run) const override;
};

}  // namespace quell

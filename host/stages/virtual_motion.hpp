// Host side of the stage virtual_motion.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/virtual_motion_ports.h"

namespace quell {

QUELL_OPTIONS(VirtualMotionOptions, VIRTUAL_MOTION, "virtual_motion")

/// See kernels/virtual_motion.cl for what it computes, from what and after which paper.
class VirtualMotion : public KernelStage<VirtualMotionOptions, VirtualMotionParams> {
 public:
  /// `skip`: leaves out background.
  VirtualMotion(const Configuration& configuration, bool skip);

 protected:
  VirtualMotionParams params(const FrameRun& run) const override;
};

}  // namespace quell

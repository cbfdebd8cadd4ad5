// Host side of the stage follow_change.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/change_detection.hpp"
#include "kernels/follow_change_ports.h"

namespace quell {

QUELL_OPTIONS(FollowChangeOptions, FOLLOW_CHANGE, "follow_change")

/// See kernels/follow_change.cl for what it computes, from what and after which paper.
class FollowChange : public KernelStage<FollowChangeOptions, ChangeParams> {
 public:
  /// `skip`: leaves out background; see kernels/common/surfaces.h.
  FollowChange(const Configuration& configuration, const ChangeDetection& detection, bool skip);

 protected:
  ChangeParams params(const FrameRun& run) const override;

 private:
  ChangeDetection m_detection;
};

}  // namespace quell

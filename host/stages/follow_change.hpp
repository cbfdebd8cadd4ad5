// Host side of the stage follow_change.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/change_tiles.hpp"

namespace quell {

/// See kernels/follow_change.cl for what it computes, from what and after which paper.
class FollowChange : public Stage {
 public:
  /// `skip`: leaves out background; see kernels/common/surfaces.h.
  FollowChange(const ChangeDetection& detection, bool skip) : m_detection(detection), m_skip(skip) {}
  std::string name() const override { return "follow_change"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration&) const override { return 0; }

 private:
  ChangeDetection m_detection;
  bool m_skip;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell

// Host side of the stage change_sums.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/change_tiles.hpp"

namespace quell {

/// See kernels/change_sums.cl for what it computes, from what and after which paper.
class ChangeSums : public Stage {
 public:
  explicit ChangeSums(const ChangeDetection& detection) : m_detection(detection) {}
  std::string name() const override { return "change_sums"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration&) const override { return 0; }

 private:
  ChangeDetection m_detection;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell

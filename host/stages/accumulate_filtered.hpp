// Host side of the stage accumulate_filtered.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/accumulate_filtered_params.h"

namespace quell {

/// See kernels/accumulate_filtered.cl for what it computes, from what and after which paper.
class AccumulateFiltered : public Stage {
 public:
  /// `leastWeight`: least weight of the newest filtered frame, (0, 1].
  explicit AccumulateFiltered(double leastWeight) : m_leastWeight(leastWeight) {}
  std::string name() const override { return "accumulate_filtered"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  double m_leastWeight;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell

// Host side of the stage weighted_sum.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/fit_params.h"

namespace quell {

/// See kernels/weighted_sum.cl for what it computes, from what and after which paper.
class WeightedSum : public Stage {
 public:
  std::string name() const override { return "weighted_sum"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell

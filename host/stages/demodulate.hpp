// Host side of the stage demodulate.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/demodulate_params.h"

namespace quell {

/// See kernels/demodulate.cl for what it computes, from what and after which paper.
class Demodulate : public Stage {
 public:
  std::string name() const override { return "demodulate"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell

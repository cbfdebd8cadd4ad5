// Host side of the stage background.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/background_params.h"

namespace quell {

/// See kernels/background.cl for what it computes, from what and after which paper.
class Background : public Stage {
 public:
  /// `antialias`: whether temporal_antialiasing follows.
  explicit Background(bool antialias) : m_antialias(antialias) {}
  std::string name() const override { return "background"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration& configuration) const override;

 private:
  bool m_antialias;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell

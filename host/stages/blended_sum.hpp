// Host side of the stage blended_sum.
#pragma once

#include "host/stages/gram_windows.hpp"

namespace quell {

/// See kernels/blended_sum.cl for what it computes, from what and after which paper.
class BlendedSum : public Stage {
 public:
  /// `signal`: the one that is fitted, 0 or 1.
  BlendedSum(const GramWindows& windows, const FitFeatures& features, int signal)
      : m_windows(windows), m_features(features), m_signal(signal) {}
  std::string name() const override { return "blended_sum"; }
  std::string label() const override;
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration&) const override { return 0; }

 private:
  GramWindows m_windows;
  FitFeatures m_features;
  int m_signal;
  cl::Kernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell

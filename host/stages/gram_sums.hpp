// Host side of the stage gram_sums.
#pragma once

#include "host/stages/gram_windows.hpp"

namespace quell {

/// See kernels/gram_sums.cl for what it computes, from what and after which paper.
class GramSums : public Stage {
 public:
  /// `signal`: the one that is fitted, 0 or 1.
  GramSums(const GramWindows& windows, const FitFeatures& features, int signal)
      : m_windows(windows), m_features(features), m_signal(signal) {}
  std::string name() const override { return "gram_sums"; }
  std::string label() const override;
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration&) const override { return 0; }

 private:
  GramWindows m_windows;
  FitFeatures m_features;
  int m_signal;
  std::size_t m_groupSize = 1;
  cl::Kernel m_kernel;
};

}  // namespace quell

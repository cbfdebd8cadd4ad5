// Host side of the stage gram_solve.
#pragma once

#include "host/stages/gram_windows.hpp"

namespace quell {

/// See kernels/gram_solve.cl for what it computes, from what and after which paper.
class GramSolve : public Stage {
 public:
  /// `noiseAmplitude`: see makeGramParams.
  GramSolve(const GramWindows& windows, double noiseAmplitude, const FitFeatures& features)
      : m_windows(windows), m_noiseAmplitude(noiseAmplitude), m_features(features) {}
  std::string name() const override { return "gram_solve"; }
  void build(const KernelBuilder& builder) override;
  void enqueue(FrameRun& run) override;
  std::uint64_t callerBytes(const Configuration&) const override { return 0; }

 private:
  GramWindows m_windows;
  double m_noiseAmplitude;
  FitFeatures m_features;
  cl::Kernel m_kernel;
  std::size_t m_groupSize = 1;
};

}  // namespace quell

// Host side of the stage gram_solve.
#pragma once

#include "host/stages/gram_windows.hpp"
#include "kernels/gram_solve_ports.h"

namespace quell {

QUELL_OPTIONS(GramSolveOptions, GRAM_SOLVE, "gram_solve")

/// See kernels/gram_solve.cl for what it computes, from what and after which paper.
class GramSolve : public KernelStage<GramSolveOptions, GramParams> {
 public:
  /// `noiseAmplitude`: see makeGramParams.
  GramSolve(const Configuration& configuration, const GramWindows& windows, double noiseAmplitude,
            const FitFeatures& features);
  void build(const KernelBuilder& builder) override;

 protected:
  GramParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override;
  std::string textDefines() const override { return m_features.gramOptions(m_windows.overlap); }

 private:
  GramWindows m_windows;
  double m_noiseAmplitude;
  FitFeatures m_features;
};

}  // namespace quell

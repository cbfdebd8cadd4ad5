// Host side of the stage blended_sum.
#pragma once

#include "host/stages/gram_windows.hpp"
#include "kernels/blended_sum_ports.h"

namespace quell {

QUELL_OPTIONS(BlendedSumOptions, BLENDED_SUM, "blended_sum")

/// See kernels/blended_sum.cl for what it computes, from what and after which paper.
class BlendedSum : public KernelStage<BlendedSumOptions, GramParams> {
 public:
  /// `signal`: the one that is fitted, 0 or 1; `skip`: leaves out background.
  BlendedSum(const Configuration& configuration, const GramWindows& windows, const FitFeatures& features,
             int signal, bool skip);
  std::string label() const override { return name() + signalLabel(QUELL_SIGNAL); }

 protected:
  GramParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override;
  std::string textDefines() const override { return m_features.options(); }

 private:
  GramWindows m_windows;
  FitFeatures m_features;
};

}  // namespace quell

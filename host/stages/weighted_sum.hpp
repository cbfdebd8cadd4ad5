// Host side of the stage weighted_sum.
#pragma once

#include "host/stages/fit.hpp"
#include "kernels/weighted_sum_ports.h"

namespace quell {

QUELL_OPTIONS(WeightedSumOptions, WEIGHTED_SUM, "weighted_sum")

/// See kernels/weighted_sum.cl for what it computes, from what and after which paper.
class WeightedSum : public KernelStage<WeightedSumOptions, FitParams> {
 public:
  /// `signal`: the one that is fitted, 0 or 1; `skip`: leaves out background.
  WeightedSum(const Configuration& configuration, const FitFeatures& features, int signal, bool skip);
  std::string label() const override { return name() + signalLabel(QUELL_SIGNAL); }

 protected:
  FitParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override;
  std::string textDefines() const override { return m_features.options(); }

 private:
  FitFeatures m_features;
};

}  // namespace quell

// Host side of the stage gram_sums.
#pragma once

#include "host/stages/gram_windows.hpp"
#include "kernels/gram_sums_ports.h"

namespace quell {

QUELL_OPTIONS(GramSumsOptions, GRAM_SUMS, "gram_sums")

/// See kernels/gram_sums.cl for what it computes, from what and after which paper.
class GramSums : public KernelStage<GramSumsOptions, GramParams> {
 public:
  /// `signal`: the one that is fitted, 0 or 1; `tapWeights`: weights of the stage firefly_weights; `skip`: leaves out
  /// tiles of background (where one work-item has a tile).
  GramSums(const Configuration& configuration, const GramWindows& windows, const FitFeatures& features,
           int signal, bool tapWeights, bool skip);
  std::string label() const override { return name() + signalLabel(QUELL_SIGNAL); }
  void build(const KernelBuilder& builder) override;

 protected:
  GramParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override;
  std::string textDefines() const override { return m_features.gramOptions(m_windows.overlap); }

 private:
  GramWindows m_windows;
  FitFeatures m_features;
};

}  // namespace quell

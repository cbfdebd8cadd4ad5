// Case of the stage blended_sum.
#pragma once

#include "tests/cases/gram_sums_case.hpp"
#include "tests/oracle/blended_sum_oracle.hpp"

namespace quell::tests {

/// Relative to the sum of the magnitudes of the terms, which may cancel.
constexpr double kBlendedSumTolerance = 1e-6;

class BlendedSumCase : public StageCase {
 public:
  /// Random coefficients over the test scene.
  explicit BlendedSumCase(const CaseOptions& options, GramWindows windows = kOverlap8);

  BlendedSumInputs inputs;

  /// The grid of this frame.
  void useFrame(std::uint32_t frameIndex);

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kBlendedSumTolerance; }
  Planes fitted() const { return m_harness.download("fitted"); }

 private:
  GramWindows m_windows;
  FitFeatures m_features;
};

}  // namespace quell::tests

// Case of the stage weighted_sum.
#pragma once

#include "tests/cases/stage_case.hpp"
#include "tests/oracle/weighted_sum_oracle.hpp"

namespace quell::tests {

/// Relative to the sum of the magnitudes of the ten terms, which may cancel.
constexpr double kWeightedSumTolerance = 1e-6;

class WeightedSumCase : public StageCase {
 public:
  /// Random coefficients over the test scene, random materials.
  explicit WeightedSumCase(const CaseOptions& options);

  WeightedSumInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kWeightedSumTolerance; }
  Planes fitted() const { return m_harness.download("fitted"); }
  /// The block grid of this frame.
  void useFrame(std::uint32_t frameIndex);

 private:
  FitFeatures m_features;
};

}  // namespace quell::tests

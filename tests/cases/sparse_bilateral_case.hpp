// Case of the stage sparse_bilateral.
#pragma once

#include "tests/cases/edagi_inputs.hpp"
#include "tests/oracle/sparse_bilateral_oracle.hpp"

namespace quell::tests {

/// Relative to the brightest channel: means of up to 51 terms with penalties of up to 9, whose eighth powers lose a digit.
constexpr double kSparseBilateralTolerance = 4e-5;

/// The disc of the history, or that which follows confidence: everywhere other.
class SparseBilateralCase : public StageCase {
 public:
  explicit SparseBilateralCase(const CaseOptions& options, bool followsConfidence = false);

  SparseBilateralInputs inputs;

  void useFrame(std::uint32_t frameIndex) { m_frameIndex = inputs.frameIndex = frameIndex; }
  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kSparseBilateralTolerance; }
  Planes filtered() const { return planesOf(m_harness.download("sparseOutput"), 0, 3); }

 protected:
  std::vector<LightInput> light() override { return {lightOf(inputs.irradiance)}; }
};

}  // namespace quell::tests

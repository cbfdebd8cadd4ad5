// Case of the stage separable_bilateral.
#pragma once

#include "tests/cases/edagi_inputs.hpp"
#include "tests/oracle/separable_bilateral_oracle.hpp"

namespace quell::tests {

/// Relative to the brightest channel: means of up to 29 terms with penalties of up to 9, whose eighth powers lose a digit.
constexpr double kSeparableBilateralTolerance = 4e-5;

/// The glossy signal over the scene of filter_inputs.hpp, in columns or in rows, with or without roughness.
class SeparableBilateralCase : public StageCase {
 public:
  explicit SeparableBilateralCase(const CaseOptions& options, bool alongRows = false, bool roughness = true);

  SeparableBilateralInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kSeparableBilateralTolerance; }
  Planes filtered() const { return planesOf(m_harness.download("separableOutput"), 3, 3); }

 protected:
  std::vector<LightInput> light() override { return {lightOf(inputs.irradiance)}; }
};

}  // namespace quell::tests

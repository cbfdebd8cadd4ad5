// Case of the stage guided_evaluate.
#pragma once

#include "tests/cases/guided_inputs.hpp"
#include "tests/oracle/guided_evaluate_oracle.hpp"

namespace quell::tests {

/// Relative to the sum of the magnitudes: twenty products and a quotient.
constexpr double kGuidedEvaluateTolerance = 4e-6;

/// Random coefficients, some of no window at all, over the scene of filter_inputs.hpp.
class GuidedEvaluateCase : public StageCase {
 public:
  explicit GuidedEvaluateCase(const CaseOptions& options, const GuidedVariant& variant = {});

  GuidedEvaluateInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kGuidedEvaluateTolerance; }
  Planes irradiance() const { return m_harness.download("guidedIrradiance"); }
};

}  // namespace quell::tests

// Case of the stage guided_moments.
#pragma once

#include "tests/cases/guided_inputs.hpp"
#include "tests/oracle/guided_moments_oracle.hpp"

namespace quell::tests {

/// Relative to the sum of the magnitudes: at most 64 products, in chains of 8 to 32.
constexpr double kGuidedMomentsTolerance = 4e-6;

/// Light over the scene of filter_inputs.hpp: weights of all sizes, none, and holes.
class GuidedMomentsCase : public StageCase {
 public:
  explicit GuidedMomentsCase(const CaseOptions& options, const GuidedVariant& variant = {});

  GuidedMomentsInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kGuidedMomentsTolerance; }
  /// Of cells.
  Planes moments() const;

 protected:
  std::vector<LightInput> light() override { return {lightOf(inputs.irradiance)}; }
};

}  // namespace quell::tests

// Case of the stage follow_change.
#pragma once

#include "tests/cases/change_inputs.hpp"
#include "tests/oracle/follow_change_oracle.hpp"

namespace quell::tests {

/// Relative to the largest of a pixel's values before and after: an interpolated weight and a blend.
constexpr double kFollowChangeTolerance = 2e-6;

struct FollowChangeOutputs {
  Planes irradiance, moments, historyLength;
};

/// Weights of which half are 0, histories of all lengths. The stage works in place: run it once an upload().
class FollowChangeCase : public StageCase {
 public:
  explicit FollowChangeCase(const CaseOptions& options, int signals = 1);

  FollowChangeInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kFollowChangeTolerance; }
  FollowChangeOutputs outputs() const;

 protected:
  std::vector<LightInput> light() override;
};

}  // namespace quell::tests

// Case of the stage light_sums.
#pragma once

#include "tests/cases/stage_case.hpp"
#include "tests/oracle/light_sums_oracle.hpp"

namespace quell::tests {

/// Relative to the sum of the magnitudes: 32 products in 8 chains of 4 and a tree of 3 levels.
constexpr double kLightSumsTolerance = 1e-6;

/// Filtered light on either side of that of the history; weights of all sizes, none, and holes.
class LightSumsCase : public StageCase {
 public:
  explicit LightSumsCase(const CaseOptions& options, int signals = 1);

  LightSumsInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kLightSumsTolerance; }
  /// Without what lies behind the records.
  Planes sums() const;

 protected:
  std::vector<LightInput> light() override {
    return {lightOf(inputs.stopLuminance), lightOf(inputs.filtered)};
  }
};

}  // namespace quell::tests

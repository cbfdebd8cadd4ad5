// Case of the stage change_sums.
#pragma once

#include "tests/cases/change_inputs.hpp"
#include "tests/oracle/change_sums_oracle.hpp"

namespace quell::tests {

/// Relative to the sum of the magnitudes: 64 products in 8 chains of 8 and a tree of 3 levels.
constexpr double kChangeSumsTolerance = 1e-6;

/// Differences of both signs; histories of all lengths; sums of a frame before.
class ChangeSumsCase : public StageCase {
 public:
  explicit ChangeSumsCase(const CaseOptions& options, int signals = 1);

  ChangeSumsInputs inputs;

  /// Frames since the history was reset.
  void useFrame(std::uint32_t frameIndex);

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kChangeSumsTolerance; }
  Planes sums() const { return m_harness.download("changeSums"); }

 protected:
  std::vector<LightInput> light() override {
    std::vector<LightInput> all = lightOfRecords(inputs.sumsPrev);
    all.push_back(lightOf(inputs.innovation));
    return all;
  }
};

}  // namespace quell::tests

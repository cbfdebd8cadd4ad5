// Case of the stage accumulate_filtered.
#pragma once

#include "tests/cases/stage_case.hpp"
#include "tests/oracle/accumulate_filtered_oracle.hpp"

namespace quell::tests {

/// Relative to the brightest channel of the pixel: a weighted mean of five non-negative terms, about ten
/// float operations.
constexpr double kAccumulateFilteredTolerance = 1e-6;

class AccumulateFilteredCase : public StageCase {
 public:
  explicit AccumulateFilteredCase(const CaseOptions& options);

  AccumulateFilteredInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kAccumulateFilteredTolerance; }
  Planes filtered() const { return m_harness.download("filtered"); }

 protected:
  std::vector<LightInput> light() override { return {lightOf(inputs.fitted), lightOf(inputs.filteredPrev)}; }
};

}  // namespace quell::tests

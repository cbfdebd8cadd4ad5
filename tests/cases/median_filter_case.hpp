// Case of the stage median_filter.
#pragma once

#include "tests/cases/edagi_inputs.hpp"
#include "tests/oracle/median_filter_oracle.hpp"

namespace quell::tests {

/// Random light; weights of all sizes, none, and holes.
class MedianFilterCase : public StageCase {
 public:
  explicit MedianFilterCase(const CaseOptions& options);

  Planes irradiance;  ///< of two signals
  Planes guides;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return 0.0; }
  Planes medians() const { return planesOf(m_harness.download("medianOutput"), 0, 3); }

 protected:
  std::vector<LightInput> light() override { return {lightOf(irradiance)}; }
};

}  // namespace quell::tests

// Case of the stage demodulate.
#pragma once

#include "tests/cases/frame_inputs.hpp"
#include "tests/oracle/demodulate_oracle.hpp"

namespace quell::tests {

/// Relative to the largest component of the pixel: about ten float operations.
constexpr double kDemodulateTolerance = 1e-6;

/// F_beta: a lookup at a place that is rounded to 1e-5 texels.
constexpr double kFBetaTolerance = 2e-5;

class DemodulateCase : public StageCase {
 public:
  explicit DemodulateCase(const CaseOptions& options, const FrameVariant& variant = {});

  FrameImages inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kDemodulateTolerance; }
  Planes irradiance() const { return m_harness.download("irradiance"); }
  Planes guides() const { return m_harness.download("guides"); }

 protected:
  std::vector<LightInput> light() override { return lightOf(inputs.material); }
};

}  // namespace quell::tests

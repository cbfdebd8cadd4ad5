// Case of the stage firefly_weights.
#pragma once

#include "tests/cases/filter_inputs.hpp"
#include "tests/oracle/firefly_oracle.hpp"

namespace quell::tests {

/// Relative to the weight: the square of the ratio of two luminances, in float (4e-7 measured).
constexpr double kFireflyWeightsTolerance = 1e-6;

/// Random light, in which a pixel in fifty is far brighter than any other, over the scene of filter_inputs.hpp.
class FireflyWeightsCase : public StageCase {
 public:
  explicit FireflyWeightsCase(const CaseOptions& options, int signals = 1);

  FireflyWeightsInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kFireflyWeightsTolerance; }
  Planes weights() const { return m_harness.download("tapWeights"); }

 protected:
  std::vector<LightInput> light() override { return {lightOf(inputs.irradiance)}; }
};

/// Brightens a pixel in fifty.
void addFireflies(Planes& irradiance, unsigned seed);

/// Compares weights pixel by pixel, each relative to itself.
void compareTapWeights(Comparison& comparison, const Planes& device, const ExactPlanes& exact);

}  // namespace quell::tests

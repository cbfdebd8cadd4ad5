// Case of the stage variance.
#pragma once

#include "tests/cases/filter_inputs.hpp"
#include "tests/oracle/variance_oracle.hpp"

namespace quell::tests {

/// Relative to the second moment, which the square of the first is subtracted from. Errors of a weighted
/// mean, whose weights are off by the 1e-5 of the polynomial in place of e^-x and by the rounding of a cosine, 2e-7,
/// times the normals' power of 100, mostly cancel (1e-6 measured).
constexpr double kVarianceTolerance = 1e-5;

/// Of the samples, as the paper of svgf has it, or of their mean, as quell has it, with weights for taps and luminance
/// for stops.
enum class VarianceOf { Samples, Mean };

/// Histories of all lengths over the scene of filter_inputs.hpp.
class VarianceCase : public StageCase {
 public:
  explicit VarianceCase(const CaseOptions& options, int signals = 1, VarianceOf of = VarianceOf::Samples);

  VarianceInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kVarianceTolerance; }
  Planes variance() const { return m_harness.download("variance"); }

 protected:
  std::vector<LightInput> light() override {
    std::vector<LightInput> light = momentsOf(inputs.moments);
    light.push_back(lightOf(inputs.irradiance));
    return light;
  }
};

}  // namespace quell::tests

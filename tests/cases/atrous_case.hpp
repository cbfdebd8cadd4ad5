// Case of the stage atrous.
#pragma once

#include "tests/cases/filter_inputs.hpp"
#include "tests/oracle/atrous_oracle.hpp"

namespace quell::tests {

/// Relative to the largest component of the pixel. Weights are off by the 1e-5 of the polynomial in place of e^-x, by
/// the rounding of a cosine, 2e-7, times the normals' power of 100, and by that of penalties up to 20; the weighted
/// mean of them by about as much (5e-6 measured).
constexpr double kAtrousTolerance = 2e-5;

/// First iterations of quell whose stops compare prefiltered luminance.
constexpr int kPrefilteredIterations = 2;

struct AtrousVariant {
  FilterVariant images;
  bool variance = true;  ///< iterations of svgf, else of the method atrous
  int iteration = 1;     ///< from 1
  /// Iterations of quell: 5x5 taps without corners, 3x3 from the second on and these without corners from the fourth
  /// on, and a narrower stop on luminance below this roughness; negative: of svgf.
  double sharpRoughness = -1.0;

  bool ofQuell() const { return sharpRoughness >= 0.0; }
  bool prefiltered() const { return ofQuell() && iteration <= kPrefilteredIterations; }
};

/// Noise over the scene of filter_inputs.hpp.
class AtrousCase : public StageCase {
 public:
  explicit AtrousCase(const CaseOptions& options, const AtrousVariant& variant = {});

  AtrousInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kAtrousTolerance; }
  Planes irradiance() const { return m_harness.download("filteredIrradiance"); }
  /// As the stage declares. The last iteration does not, nor the method atrous: what is there then stays.
  bool filtersVariance() const;
  Planes variance() const { return m_harness.download("filteredVariance"); }
  /// What is in the output before run().
  void setVariance(const Planes& planes) { m_harness.upload("filteredVariance", planes); }

 protected:
  std::vector<LightInput> light() override {
    return {lightOf(inputs.irradiance), lightOf(inputs.stopLuminance), lightOf(inputs.variance, 2)};
  }
};

}  // namespace quell::tests

// Case of the stage gram_sums.
#pragma once

#include "host/stages/gram_windows.hpp"
#include "tests/cases/stage_case.hpp"
#include "tests/oracle/gram_sums_oracle.hpp"

namespace quell::tests {

/// The windows that the method offers.
constexpr GramWindows kBlocks{false, QUELL_BLOCK_EDGE};
constexpr GramWindows kOverlap8{true, 8};
constexpr GramWindows kOverlap16{true, 16};

/// Of a sum of a * b, relative to sqrt(sum of a^2 * sum of b^2): up to 1024 products are added in turn.
constexpr double kGramSumTolerance = 2e-6;

/// A schedule with the stages of a gram fit.
StageSetup makeGramSetup(const CaseOptions& options, const GramWindows& windows, double noiseAmplitude);

/// Random irradiance over the test scene, some pixels of less weight, random materials.
GramInputs makeGramInputs(const CaseOptions& options, const GramWindows& windows);
/// Replaces the scene by unrelated random features, which makes the problem well-conditioned.
void useRandomFeatures(Planes& guides, unsigned seed);

class GramSumsCase : public StageCase {
 public:
  explicit GramSumsCase(const CaseOptions& options, GramWindows windows = kBlocks);

  GramInputs inputs;

  /// The grid of this frame.
  void useFrame(std::uint32_t frameIndex);

  void upload() override;
  /// Sums and ranges; ranges must agree exactly.
  Comparison compare() override;
  double tolerance() const override { return kGramSumTolerance; }
  Planes tiles() const { return m_harness.download("gramTiles"); }

 protected:
  std::vector<LightInput> light() override { return {lightOf(inputs.irradiance)}; }

 private:
  GramWindows m_windows;
  FitFeatures m_features;
};

}  // namespace quell::tests

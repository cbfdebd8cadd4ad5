// Case of the stage gram_solve.
#pragma once

#include "tests/cases/gram_sums_case.hpp"
#include "tests/oracle/gram_solve_oracle.hpp"

namespace quell::tests {

/// Predictions at the window's pixels, relative to the window's brightest irradiance, against the solution of
/// the same sums: rounding of 6e-8 times a part of the condition, which the noise keeps below about 5e4.
constexpr double kGramSolveTolerance = 1e-3;
/// The same against sums straight from the pixels: the tiles' sums are rounded to float in their own scaling.
constexpr double kGramPixelsTolerance = 1e-3;
/// Coefficients, relative to the largest of their channel, where the condition is below kGramWellConditioned.
constexpr double kGramCoefficientTolerance = 1e-4;
constexpr double kGramWellConditioned = 100.0;

class GramSolveCase : public StageCase {
 public:
  explicit GramSolveCase(const CaseOptions& options, GramWindows windows = kBlocks,
                         double noiseAmplitude = 0.01);

  /// The pixels whose sums the stage gets.
  GramInputs inputs;
  /// As tiles() of the stage gram_sums; upload() takes the oracle's sums of the pixels where this is empty.
  Planes tiles;

  /// The grid of this frame.
  void useFrame(std::uint32_t frameIndex);

  void upload() override;
  /// Predictions against the solution of the tiles' sums.
  Comparison compare() override;
  double tolerance() const override { return kGramSolveTolerance; }
  /// Predictions against the solution of sums straight from the pixels, after run().
  Comparison comparePixels() const;
  /// Predictions against those of other records, in windows with at least this sum of weights.
  Comparison compareRecords(const Planes& others, double leastWeight = 0.0) const;
  /// Coefficients of the well-conditioned windows, after run().
  Comparison compareCoefficients() const;
  Planes records() const { return m_harness.download("fitRecords"); }

 protected:
  /// Sums that a test gives stay as they are.
  std::vector<LightInput> light() override {
    if (!tiles.values.empty()) return {};
    return {lightOf(inputs.irradiance)};
  }

 private:
  Comparison comparePredictions(const std::vector<GramFit>& exact) const;
  std::vector<BlockPixel> windowPixels(int window) const;
  GramSolveInputs solveInputs() const {
    return {m_uploaded, inputs.params, m_windows.overlap, m_list, inputs.list};
  }

  GramWindows m_windows;
  double m_noiseAmplitude;
  FeatureNames m_list;
  Planes m_uploaded;
};

}  // namespace quell::tests

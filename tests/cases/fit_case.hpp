// Case of the stage fit.
#pragma once

#include "host/stages/fit.hpp"
#include "tests/cases/stage_case.hpp"
#include "tests/oracle/fit_oracle.hpp"

namespace quell::tests {

/// Predictions at the block's pixels, relative to the block's brightest irradiance. The matrix [T + N] has a
/// condition of about 200 where a feature is constant and only noise keeps it independent; Householder QR in
/// float loses that factor times the rounding of 6e-8.
constexpr double kFitTolerance = 1e-5;
/// The same with the columns stored as halves: every step of the factorisation rounds them to 11 bits.
constexpr double kFitHalfTolerance = 0.005;
/// Coefficients, relative to the largest of their channel, where the condition is below kFitWellConditioned.
constexpr double kFitCoefficientTolerance = 1e-5;
constexpr double kFitWellConditioned = 100.0;

class FitCase : public StageCase {
 public:
  /// Random irradiance over the test scene, random materials.
  explicit FitCase(const CaseOptions& options, FeatureStorage storage = FeatureStorage::Float,
                   double noiseAmplitude = 0.01);

  FitInputs inputs;

  /// Replaces the scene by unrelated random features, which makes the problem well-conditioned.
  void useRandomFeatures(unsigned seed);
  /// The block grid of this frame.
  void useFrame(std::uint32_t frameIndex);

  void upload() override;
  Comparison compare() override;
  double tolerance() const override {
    return m_storage == FeatureStorage::Half ? kFitHalfTolerance : kFitTolerance;
  }
  /// Coefficients of the well-conditioned blocks, after run().
  Comparison compareCoefficients() const;
  Planes records() const { return m_harness.download("fitRecords"); }

 protected:
  std::vector<LightInput> light() override { return {lightOf(inputs.irradiance)}; }

 private:
  FeatureStorage m_storage;
  FitFeatures m_features;
};

}  // namespace quell::tests

// Case of the stage temporal_antialiasing.
#pragma once

#include "tests/cases/stage_case.hpp"
#include "tests/oracle/temporal_antialiasing_oracle.hpp"

namespace quell::tests {

/// Relative to the largest radiance: YCoCg with its gains goes through about ten float operations.
constexpr double kTemporalAntialiasingTolerance = 1e-6;

class TemporalAntialiasingCase : public StageCase {
 public:
  /// The caller's images are in options.layout; with jittered rays there is a linear one as well.
  explicit TemporalAntialiasingCase(const CaseOptions& options, bool jitteredRays = false);

  TemporalAntialiasingInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kTemporalAntialiasingTolerance + storageError(m_layout); }
  Planes antialiased() const { return m_harness.download("antialiased"); }

 protected:
  std::vector<LightInput> light() override {
    return {lightOf(inputs.denoised), lightOf(inputs.antialiasedPrev)};
  }

 private:
  ImageLayout m_layout;
  bool m_jitteredRays;
};

}  // namespace quell::tests

// Case of the stage temporal_antialiasing.
#pragma once

#include "tests/cases/stage_case.hpp"
#include "tests/oracle/temporal_antialiasing_oracle.hpp"

namespace quell::tests {

/// Absolute: values up to 4 (YCoCg with its gains) go through about ten float operations.
constexpr double kTemporalAntialiasingTolerance = 1e-6;

class TemporalAntialiasingCase : public StageCase {
 public:
  /// The display image is in options.layout.
  explicit TemporalAntialiasingCase(const CaseOptions& options);

  TemporalAntialiasingInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kTemporalAntialiasingTolerance + storageError(m_layout); }
  Planes antialiased() const { return m_harness.download("antialiased"); }

 private:
  ImageLayout m_layout;
};

}  // namespace quell::tests

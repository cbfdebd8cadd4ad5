// Case of the stage soft_history.
#pragma once

#include "tests/cases/edagi_inputs.hpp"
#include "tests/oracle/soft_history_oracle.hpp"

namespace quell::tests {

/// Relative to the brightest that goes in: the deviation of samples that are nearly alike is a difference of squares, of
/// which half the digits are left.
constexpr double kSoftHistoryTolerance = 4e-4;

/// The matte signal, with the surface's positions, or the glossy one with virtual ones.
class SoftHistoryCase : public StageCase {
 public:
  explicit SoftHistoryCase(const CaseOptions& options, int signal = 0, bool motion = false);

  SoftHistoryInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kSoftHistoryTolerance; }
  Planes blended() const { return planesOf(m_harness.download("blended"), 3 * m_signal, 3); }
  Planes confidence() const { return planesOf(m_harness.download("confidence"), m_signal, 1); }

 protected:
  std::vector<LightInput> light() override {
    return {lightOf(inputs.irradiance), lightOf(inputs.historyPrev)};
  }

 private:
  int m_signal;
  Planes m_guides;
};

}  // namespace quell::tests

// Case of the stage low_confidence.
#pragma once

#include "tests/cases/edagi_inputs.hpp"
#include "tests/oracle/low_confidence_oracle.hpp"

namespace quell::tests {

/// Random confidences, most of them 1; weights of all sizes, none, and holes.
class LowConfidenceCase : public StageCase {
 public:
  explicit LowConfidenceCase(const CaseOptions& options);

  Planes confidence;  ///< of two signals
  Planes guides;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return 0.0; }
  Planes cells() const;
};

}  // namespace quell::tests

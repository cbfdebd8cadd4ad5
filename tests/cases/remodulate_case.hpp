// Case of the stage remodulate.
#pragma once

#include "tests/cases/material_inputs.hpp"
#include "tests/oracle/remodulate_oracle.hpp"

namespace quell::tests {

/// Relative to the largest of the terms that are blended and added: about ten float operations, the
/// smoothstep the longest of them.
constexpr double kRemodulateTolerance = 1e-6;

class RemodulateCase : public StageCase {
 public:
  /// The caller's inputs and the linear output are in options.layout; planes are written as well.
  explicit RemodulateCase(const CaseOptions& options, const MaterialVariant& variant = kFullMaterial);

  RemodulateInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kRemodulateTolerance + storageError(m_layout); }
  Planes linear() const { return m_harness.download("linear"); }

 private:
  ImageLayout m_layout;
};

}  // namespace quell::tests

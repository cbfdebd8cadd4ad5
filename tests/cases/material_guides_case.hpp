// Case of the stage material_guides.
#pragma once

#include "tests/cases/stage_case.hpp"
#include "tests/oracle/material_guides_oracle.hpp"

namespace quell::tests {

class MaterialGuidesCase : public StageCase {
 public:
  /// Random images, some values out of range; albedo in options.layout, roughness in its format with one channel.
  explicit MaterialGuidesCase(const CaseOptions& options);

  MaterialGuidesInputs inputs;

  void upload() override;
  Comparison compare() override;
  /// What is read is stored as it is.
  double tolerance() const override { return storageError(m_layout); }
  Planes materials() const { return m_harness.download("materials"); }

 private:
  ImageLayout m_layout;
};

}  // namespace quell::tests

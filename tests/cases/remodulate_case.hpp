// Case of the stage remodulate.
#pragma once

#include "tests/cases/material_inputs.hpp"
#include "tests/oracle/remodulate_oracle.hpp"

namespace quell::tests {

/// Relative to the largest of the terms that are blended and added: about ten float operations, the smoothstep the longest
/// of them. The encoding more than halves a relative error and adds kEncodingTolerance.
constexpr double kRemodulateTolerance = 1e-6;

class RemodulateCase : public StageCase {
 public:
  /// The caller's inputs and outputs are in options.layout. `isLast`: encoded radiance goes to the caller's display
  /// image instead of planes for antialiasing.
  explicit RemodulateCase(const CaseOptions& options, const MaterialVariant& variant = kFullMaterial,
                          bool isLast = false);

  RemodulateInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kRemodulateTolerance + storageError(m_layout); }
  Planes linear() const { return outputPlanes(m_harness, &Output::linear); }
  Planes encoded() const { return m_harness.download("encoded"); }

 protected:
  std::vector<LightInput> light() override {
    std::vector<LightInput> inputsOfLight = lightOf(inputs.material);
    inputsOfLight.push_back(lightOf(inputs.filtered));
    return inputsOfLight;
  }

 private:
  bool m_isLast;
  ImageLayout m_layout;
};

}  // namespace quell::tests

// Case of the stage remodulate.
#pragma once

#include "tests/cases/material_inputs.hpp"
#include "tests/oracle/remodulate_oracle.hpp"

namespace quell::tests {

/// Relative to the largest of the terms that are blended and added: about ten float operations, the smoothstep the longest
/// of them. The encoding more than halves a relative error and adds kEncodingTolerance.
constexpr double kRemodulateTolerance = 1e-6;

/// Where radiance goes.
enum class RemodulateTo {
  Outputs,           ///< the caller's linear and display images
  Antialiasing,      ///< planes for antialiasing, and the caller's linear image
  AntialiasingOnly,  ///< planes alone: rays are jittered
};

/// What the method does about light that its filter loses.
enum class LightLoss { Left, GivenBack };

class RemodulateCase : public StageCase {
 public:
  /// The caller's inputs and outputs are in options.layout.
  explicit RemodulateCase(const CaseOptions& options, const MaterialVariant& variant = kFullMaterial,
                          RemodulateTo to = RemodulateTo::Antialiasing, LightLoss loss = LightLoss::Left,
                          const DisplayTransform& transform = {});

  RemodulateInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kRemodulateTolerance + storageError(m_layout); }
  Planes linear() const { return outputPlanes(m_harness, &Output::linear); }
  Planes display() const { return outputPlanes(m_harness, &Output::display); }

 protected:
  std::vector<LightInput> light() override {
    std::vector<LightInput> inputsOfLight = lightOf(inputs.material);
    inputsOfLight.push_back(lightOf(inputs.filtered));
    if (inputs.lightGain.count > 0) inputsOfLight.push_back(lightOf(inputs.lightGain, -1));
    return inputsOfLight;
  }

 private:
  RemodulateTo m_to;
  ImageLayout m_layout;
};

}  // namespace quell::tests

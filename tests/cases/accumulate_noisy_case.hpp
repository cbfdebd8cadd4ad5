// Case of the stage accumulate_noisy.
#pragma once

#include "tests/cases/frame_inputs.hpp"
#include "tests/oracle/accumulate_noisy_oracle.hpp"

namespace quell::tests {

/// Relative to the largest component of the pixel (moments: to the larger one): demodulation, a weighted mean of
/// five non-negative terms and positions up to ten scene units from the camera, about twenty float operations.
constexpr double kAccumulateNoisyTolerance = 2e-6;
/// Pixels: half a step of 1/256 and the float rounding of the reprojection.
constexpr double kPixelPrevTolerance = 0.5 / 256 + 1e-3;

struct AccumulateNoisyVariant {
  MaterialVariant material = kFullMaterial;
  bool viewDepth = false;  ///< instead of world positions
  /// As the method svgf has it: moments, view depth and, where the caller has it, roughness are written.
  bool filterGuides = false;
  bool roughness = false;  ///< whether the caller has it
  bool motion = false;     ///< whether the caller has motion vectors
  bool objectId = false;   ///< whether the caller has object ids
  /// As the method quell has it: with filterGuides, also the newest sample and how far it is from its history.
  bool innovation = false;

  FrameVariant images() const { return {material, viewDepth, roughness}; }
};

/// A moving camera before the test scene; the history is random.
class AccumulateNoisyCase : public StageCase {
 public:
  /// The caller's images are in options.layout as far as setFrameViews() can have it.
  explicit AccumulateNoisyCase(const CaseOptions& options, const AccumulateNoisyVariant& variant = {});

  AccumulateNoisyInputs inputs;

  void upload() override;
  Comparison compare() override;
  double tolerance() const override { return kAccumulateNoisyTolerance; }
  AccumulateNoisyOutputs<float> outputs() const;
  /// The caller gives every pixel this object id, in this frame and in the one before.
  void giveAllObjects(float id);
  /// After inputs.reprojection was changed.
  void useReprojection(const ReprojectionParams& reprojection);

 protected:
  std::vector<LightInput> light() override;

 private:
  AccumulateNoisyVariant m_variant;
  io::Image m_objectIds;  ///< as the caller has them; inputs.objectId holds their bits
};

}  // namespace quell::tests

// All of the caller's images of a frame, for the cases of accumulate_noisy and demodulate.
#pragma once

#include "tests/cases/material_inputs.hpp"
#include "tests/oracle/surface_oracle.hpp"

namespace quell::tests {

struct FrameVariant {
  MaterialVariant material = kFullMaterial;
  bool viewDepth = false;  ///< instead of world positions
  bool roughness = false;  ///< whether the caller has it
};

/// Views of the images that the variant has. Material images are in this layout. Normals and positions have the same
/// strides, but at least three channels, and positions are always floats: halves cannot tell surfaces apart at this
/// camera.
void setFrameViews(StageSetup& setup, const FrameVariant& variant, const ImageLayout& layout);

/// The test scene with random light, without a camera of the frame before.
FrameImages randomFrame(const FrameVariant& variant, const CaseOptions& options);

/// Sends the images; `frame` keeps what the device reads, after rounding to the layout.
void uploadFrame(StageHarness& harness, FrameImages& frame);

}  // namespace quell::tests

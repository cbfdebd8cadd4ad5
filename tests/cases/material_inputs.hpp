// Radiance and what it is divided by, for the cases of accumulate_noisy, demodulate and remodulate.
#pragma once

#include "tests/cases/stage_case.hpp"
#include "tests/oracle/demodulation_oracle.hpp"

namespace quell::tests {

/// Which of the optional images there are.
struct MaterialVariant {
  bool emission = false;
  bool albedo = false;
  bool glossColor = false;
  bool demodulated = false;
  bool twoSignals = false;
  bool divide = true;  ///< false: the setting demodulate is none
  bool fBeta = false;  ///< the setting demodulate is fbeta, and there is F0; needs roughness
  bool f0 = false;     ///< there is F0 without fBeta
};
constexpr MaterialVariant kFullMaterial{true, true, true, false};
constexpr MaterialVariant kMaterialWithF0{true, true, true, false, false, true, false, true};
constexpr MaterialVariant kPlainMaterial{false, false, false, false};
constexpr MaterialVariant kDemodulatedMaterial{true, true, false, true};
constexpr MaterialVariant kTwoSignals{true, true, true, false, true};
constexpr MaterialVariant kTwoDemodulatedSignals{true, true, true, true, true};
constexpr MaterialVariant kFBetaMaterial{true, true, true, false, false, true, true};
constexpr MaterialVariant kTwoFBetaSignals{true, true, true, false, true, true, true};
constexpr MaterialVariant kUndividedMaterial{true, true, true, false, false, false};

/// Views of the images that the variant has, all in one layout, and the setting that goes with it.
void setMaterialViews(StageSetup& setup, const MaterialVariant& variant, const ImageLayout& layout);

/// Random radiance; factors from 0 to 1, in a quarter of the pixels near 0 in most channels, where they are weak.
MaterialImages randomMaterial(const MaterialVariant& variant, Size size, unsigned seed);

std::vector<LightInput> lightOf(MaterialImages& images);

/// Sends an image, if there is one, and keeps what the device reads, after rounding to the layout.
void uploadImage(StageHarness& harness, ImageView Frame::*view, io::Image& image);

/// Sends the images; `images` keeps what the device reads, after rounding to the layout.
void uploadMaterial(StageHarness& harness, MaterialImages& images);

}  // namespace quell::tests

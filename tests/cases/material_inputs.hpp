// Radiance and what it is divided by, for the cases of accumulate_noisy and remodulate.
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
};
constexpr MaterialVariant kFullMaterial{true, true, true, false};
constexpr MaterialVariant kPlainMaterial{false, false, false, false};
constexpr MaterialVariant kDemodulatedMaterial{true, true, false, true};

/// Views of the images that the variant has, all in one layout.
void setMaterialViews(Frame& frame, const MaterialVariant& variant, const ImageLayout& layout, Size size);

/// Random radiance; factors from 0 to 1 with many near 0, where demodulation fades out.
MaterialImages randomMaterial(const MaterialVariant& variant, Size size, unsigned seed);

/// Sends the images; `images` keeps what the device reads, after rounding to the layout.
void uploadMaterial(StageHarness& harness, MaterialImages& images);

}  // namespace quell::tests

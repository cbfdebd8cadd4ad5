// Inputs of the stage atrous that its tests share.
#pragma once

#include "kernels/common/guides.h"
#include "tests/cases/atrous_case.hpp"

namespace quell::tests {

const AtrousVariant kWithoutVariance{{1, false}, false, 1};
constexpr double kSharpRoughness = 0.6;

// Two signals, a stop at roughness, 3x3 taps from the second iteration on.
inline AtrousVariant ofQuell(int iteration, double sharpRoughness = kSharpRoughness) {
  return {{2, true}, true, iteration, sharpRoughness};
}

// One surface that faces the camera, with samples everywhere.
inline void flatten(AtrousInputs& inputs) {
  fill(inputs.guides.guides, 0.0f);
  fill(inputs.guides.viewDepth, 5.0f);
  fill(inputs.stopLuminance, 1.0f);
  forEachPixel(inputs.irradiance.size(), [&](int x, int y) {
    inputs.guides.guides.at(QUELL_GUIDE_NORMAL + 2, x, y) = 1.0f;
    for (int signal = 0; signal < inputs.signals(); ++signal)
      inputs.guides.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y) = 1.0f;
  });
}

inline void setIrradiance(AtrousInputs& inputs, int x, int y, float value) {
  for (int plane = 0; plane < inputs.irradiance.count; ++plane) inputs.irradiance.at(plane, x, y) = value;
}

inline Planes filter(AtrousCase& atrous) {
  atrous.uploadAndRun();
  return atrous.irradiance();
}

}  // namespace quell::tests

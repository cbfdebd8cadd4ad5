// How the display image is made of linear radiance; kernels/common/display_encoding.h has the formulas and their sources.
#pragma once

#include <array>

#include "kernels/common/display_modes.h"

namespace quell {

enum class ToneMap {
  Clamp = QUELL_TONE_MAP_CLAMP,
  Reinhard = QUELL_TONE_MAP_REINHARD,
  Aces = QUELL_TONE_MAP_ACES,
  None = QUELL_TONE_MAP_NONE,
};
constexpr std::array<const char*, 4> choiceNames(ToneMap) { return {"clamp", "reinhard", "aces", "none"}; }

enum class DisplayEncoding {
  Gamma = QUELL_ENCODING_GAMMA,
  Srgb = QUELL_ENCODING_SRGB,
  Linear = QUELL_ENCODING_LINEAR,
};
constexpr std::array<const char*, 3> choiceNames(DisplayEncoding) { return {"gamma", "srgb", "linear"}; }

struct DisplayTransform {
  ToneMap toneMap = ToneMap::Clamp;
  DisplayEncoding encoding = DisplayEncoding::Gamma;
  double exposure = 0.0;  ///< stops: radiance is multiplied by 2^exposure
};

inline bool operator==(const DisplayTransform& a, const DisplayTransform& b) {
  return a.toneMap == b.toneMap && a.encoding == b.encoding && a.exposure == b.exposure;
}

}  // namespace quell

// What the runtime itself needs of a method's settings.
#pragma once

#include <array>

#include "host/core/display_transform.hpp"
#include "host/core/reprojection.hpp"
#include "kernels/common/demodulate_modes.h"

namespace quell {

/// What light is divided by before it is filtered.
enum class Demodulation {
  None = QUELL_DEMODULATE_NONE,
  Albedo = QUELL_DEMODULATE_ALBEDO,
  FBeta = QUELL_DEMODULATE_F_BETA,
};
constexpr std::array<const char*, 3> choiceNames(Demodulation) { return {"none", "albedo", "fbeta"}; }

struct RuntimeSettings {
  Demodulation demodulation = Demodulation::Albedo;
  DiscardLimits discard = {};
  DisplayTransform display = {};
};

}  // namespace quell

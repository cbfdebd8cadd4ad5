// Floats as the samples of OpenEXR files.
#pragma once

#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace quell::io {

/// Largest finite IEEE 754 binary16 value.
constexpr float kHalfMax = 65504.0f;

/// Half range with NaN kept: every comparison with NaN is false, so std::clamp returns it.
inline half toHalf(float value) { return half(std::clamp(value, -kHalfMax, kHalfMax)); }

/// The largest float below 2^32.
constexpr float kUintMax = 4294967040.0f;

inline std::uint32_t toUint(float value) {
  return value > 0.0f ? static_cast<std::uint32_t>(std::min(std::round(value), kUintMax)) : 0u;
}

}  // namespace quell::io

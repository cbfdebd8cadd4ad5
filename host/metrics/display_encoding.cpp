#include "host/metrics/display_encoding.hpp"

#include <algorithm>
#include <cmath>

namespace quell::metrics {

float encodeDisplay(float linear) {
  return float(std::pow(double(std::clamp(linear, 0.0f, 1.0f)), 1.0 / kDisplayGamma));
}

io::Image encodeForDisplay(const io::Image& linear) {
  io::Image encoded = linear;
  for (float& value : encoded.pixels) value = encodeDisplay(value);
  return encoded;
}

io::Image clampEncoded(const io::Image& encoded) {
  io::Image clamped = encoded;
  for (float& value : clamped.pixels) value = std::clamp(value, 0.0f, 1.0f);
  return clamped;
}

}  // namespace quell::metrics

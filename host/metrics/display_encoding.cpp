#include "host/metrics/display_encoding.hpp"

#include <algorithm>
#include <cmath>

namespace quell::metrics {
namespace {

constexpr double kMostRadiance = 65504.0;  // the largest finite half

std::array<double, 3> toneMapped(const std::array<double, 3>& exposed, ToneMap toneMap) {
  std::array<double, 3> mapped = exposed;
  const double luminance = luma(exposed[0], exposed[1], exposed[2]);  // of linear values
  for (double& v : mapped) {
    if (toneMap == ToneMap::Reinhard) v /= 1.0 + luminance;
    if (toneMap == ToneMap::Aces) v = v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14);
    v = std::clamp(v, 0.0, toneMap == ToneMap::None ? kMostRadiance : 1.0);
  }
  return mapped;
}

double encoded(double v, DisplayEncoding encoding) {
  if (encoding == DisplayEncoding::Linear) return v;
  if (encoding == DisplayEncoding::Gamma) return std::pow(v, 1.0 / kDisplayGamma);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
}

}  // namespace

std::array<double, 3> displayed(const std::array<double, 3>& linear, const DisplayTransform& transform) {
  std::array<double, 3> exposed = linear;
  for (double& v : exposed) v = std::clamp(v * std::exp2(transform.exposure), 0.0, kMostRadiance);
  std::array<double, 3> shown = toneMapped(exposed, transform.toneMap);
  for (double& v : shown) v = encoded(v, transform.encoding);
  return shown;
}

float encodeDisplay(float linear) {
  return float(std::pow(double(std::clamp(linear, 0.0f, 1.0f)), 1.0 / kDisplayGamma));
}

io::Image encodeForDisplay(const io::Image& linear) {
  io::Image encoded = linear;
  for (float& value : encoded.pixels) value = encodeDisplay(value);
  return encoded;
}

io::Image encodeForDisplay(const io::Image& linear, const DisplayTransform& transform) {
  if (transform == DisplayTransform()) return encodeForDisplay(linear);
  io::Image encoded = linear;
  for (std::size_t i = 0; i + 2 < encoded.pixels.size(); i += 3) {
    const std::array<double, 3> shown =
        displayed({linear.pixels[i], linear.pixels[i + 1], linear.pixels[i + 2]}, transform);
    for (std::size_t c = 0; c < 3; ++c) encoded.pixels[i + c] = std::min(float(shown[c]), 1.0f);
  }
  return encoded;
}

io::Image clampEncoded(const io::Image& encoded) {
  io::Image clamped = encoded;
  for (float& value : clamped.pixels) value = std::clamp(value, 0.0f, 1.0f);
  return clamped;
}

}  // namespace quell::metrics

#include "host/io/light_remainder.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace quell::io {
namespace {

/// Share of a channel's light that may be rounding: our own sequences keep 7 bits of light, 3 of them are summed up.
constexpr float kRounding = 1.0f / 64.0f;
/// Factors below this hardly let light through: kernels divide by no less.
constexpr float kLeastFactor = 0.01f;

float at(const Image& image, std::size_t i, float absent) { return image.empty() ? absent : image.pixels[i]; }

/// Of sample i; 0 where it may be rounding, or is not finite.
float remainderOf(const FrameData& frame, std::size_t i) {
  const float whole = frame.combined.pixels[i];
  const float explained = at(frame.albedo, i, 1.0f) * frame.radiance.pixels[i] +
                          at(frame.glossColor, i, 1.0f) * frame.glossyRadiance.pixels[i] +
                          at(frame.emission, i, 0.0f);
  const float remainder = whole - explained;
  return std::isfinite(remainder) && remainder > kRounding * whole ? remainder : 0.0f;
}

bool isBackground(const Image& normal, std::size_t pixel) {
  const float* n = &normal.pixels[pixel * std::size_t(normal.channels)];
  return n[0] == 0.0f && n[1] == 0.0f && n[2] == 0.0f;
}

}  // namespace

void keepRemainder(FrameData& frame, const Image& transmissionColor) {
  if (frame.combined.empty()) return;
  // Every frame has the same images.
  if (frame.albedo.empty()) frame.albedo = Image(frame.combined.width, frame.combined.height, 3, 1.0f);
  if (frame.emission.empty()) frame.emission = Image(frame.combined.width, frame.combined.height, 3);
  Image remainder(frame.combined.width, frame.combined.height, 3);
  for (std::size_t i = 0; i < remainder.pixels.size(); ++i) remainder.pixels[i] = remainderOf(frame, i);
  if (std::all_of(remainder.pixels.begin(), remainder.pixels.end(),
                  [](float light) { return light == 0.0f; }))
    return;
  for (std::size_t i = 0; i < remainder.pixels.size(); ++i) {
    if (isBackground(frame.normalWorld, i / 3)) {
      frame.emission.pixels[i] += remainder.pixels[i];
      continue;
    }
    const float before = frame.albedo.pixels[i], sum = before + at(transmissionColor, i, 0.0f);
    const float albedo = sum > kLeastFactor ? sum : 1.0f;  // false for NaN
    float& light = frame.radiance.pixels[i];
    light = (before * light + remainder.pixels[i]) / albedo;
    frame.albedo.pixels[i] = albedo;
  }
}

}  // namespace quell::io

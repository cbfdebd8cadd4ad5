// Small images with known content, and a bitwise comparison that takes NaN for equal to NaN.
#pragma once

#include <cmath>
#include <random>

#include "host/io/image.hpp"

namespace quell::tests {

/// Uniform noise in [low, high], the same for the same seed on every platform.
inline io::Image noiseImage(int width, int height, int channels, unsigned seed, float low = 0.0f,
                            float high = 1.0f) {
  std::mt19937 generator(seed);
  io::Image image(width, height, channels);
  for (float& value : image.pixels)
    value = low + (high - low) * float(double(generator()) / double(std::mt19937::max()));
  return image;
}

/// Every channel of every pixel has this value.
inline io::Image constantImage(int width, int height, float value) {
  return io::Image(width, height, 3, value);
}

inline bool samePixels(const io::Image& a, const io::Image& b) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels) return false;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    if (a.pixels[i] != b.pixels[i] && !(std::isnan(a.pixels[i]) && std::isnan(b.pixels[i]))) return false;
  return true;
}

}  // namespace quell::tests

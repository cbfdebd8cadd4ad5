// Frames with a glossy lobe of its own, and what light surfaces have, for tests of whole methods.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/pipelines/denoise_case.hpp"

namespace quell::tests {

inline io::Image image(const io::FrameData& frame, int channels, float value) {
  return io::Image(frame.radiance.width, frame.radiance.height, channels, value);
}

inline bool isBackground(const io::Image& normal, int x, int y) {
  return normal.at(x, y, 0) == 0.0f && normal.at(x, y, 1) == 0.0f && normal.at(x, y, 2) == 0.0f;
}

struct Light {
  double mean = 0.0;
  double deviation = 0.0;
};

// Of the surfaces; the sky is not filtered.
inline Light lightOf(const io::Image& linear, const io::Image& normal) {
  double count = 0.0, sum = 0.0, squares = 0.0;
  for (int y = 0; y < linear.height; ++y) {
    for (int x = 0; x < linear.width; ++x) {
      if (isBackground(normal, x, y)) continue;
      for (int c = 0; c < 3; ++c) {
        count += 1.0;
        sum += linear.at(x, y, c);
        squares += double(linear.at(x, y, c)) * linear.at(x, y, c);
      }
    }
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

// Light of its own for a glossy lobe, with gloss colour and roughness.
inline void addGloss(io::FrameData& frame) {
  frame.glossColor = image(frame, 3, 0.25f);
  frame.glossyRadiance = image(frame, 3, 0.0f);
  frame.roughness = image(frame, 1, 0.5f);
  for (int y = 0; y < frame.radiance.height; ++y) {
    for (int x = 0; x < frame.radiance.width; ++x) {
      const float noise = 0.25f * static_cast<float>((7 * x + 13 * y + 5 * frame.number) % 8);
      for (int c = 0; c < 3; ++c) frame.glossyRadiance.at(x, y, c) = noise * (0.1f + 0.05f * float(c));
      frame.roughness.at(x, y, 0) = float(x) / float(frame.radiance.width);
      frame.glossColor.at(x, y, 1) = 0.05f * float(1 + x / 8 % 4);
    }
  }
}

inline void keepDiffuse(io::FrameData& frame) {
  addGloss(frame);
  frame.glossColor = frame.glossyRadiance = io::Image();
}

inline void keepGlossy(io::FrameData& frame) {
  addGloss(frame);
  frame.radiance = frame.glossyRadiance;
  frame.albedo = frame.emission = frame.glossyRadiance = io::Image();
}

// Largest difference relative to the brightness of the pixel, at least 1.
inline double largestError(const io::Image& a, const io::Image& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    largest = std::max(
        largest, std::abs(double(a.pixels[i]) - b.pixels[i]) / std::max(1.0, std::abs(double(b.pixels[i]))));
  return largest;
}

inline io::Image sum(io::Image a, const io::Image& b) {
  for (std::size_t i = 0; i < a.pixels.size(); ++i) a.pixels[i] += b.pixels[i];
  return a;
}

}  // namespace quell::tests

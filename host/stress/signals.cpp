#include "host/stress/signals.hpp"

#include <algorithm>
#include <cmath>

#include "host/stress/geometry.hpp"

namespace quell::stress {
namespace {

using Signal = std::array<double, kBlockPixels>;

// Pixel centre over the block, each in (-1, 1).
double across(int pixel) { return (pixel % kBlockEdge + 0.5) * (2.0 / kBlockEdge) - 1.0; }
double down(int pixel) { return (pixel / kBlockEdge + 0.5) * (2.0 / kBlockEdge) - 1.0; }

// A slope with some curvature over the block, as of a light nearby.
Signal smoothLight(const Block&, Random& random) {
  const double slopeX = random.sign() * random.uniform(0.3, 1.0);
  const double slopeY = random.sign() * random.uniform(0.3, 1.0);
  double curvature[3];
  for (double& value : curvature) value = random.uniform(-0.5, 0.5);
  Signal signal;
  for (int i = 0; i < kBlockPixels; ++i) {
    const double x = across(i), y = down(i);
    signal[i] =
        4.0 + slopeX * x + slopeY * y + curvature[0] * x * x + curvature[1] * x * y + curvature[2] * y * y;
  }
  return signal;
}

// Light from half of all directions, which never leaves a surface quite dark.
Signal wideLight(const Block& block, Random& random) {
  const Vector3 light = randomDirection(random);
  Signal signal;
  for (int i = 0; i < kBlockPixels; ++i) signal[i] = 0.6 + 0.5 * dot(light, block.normalWorld[i]);
  return signal;
}

// Lambert's law for one distant light and a share of light from all sides.
Signal lambertLight(const Block& block, Random& random) {
  const Vector3 light = randomDirection(random);
  Signal signal;
  for (int i = 0; i < kBlockPixels; ++i) signal[i] = 0.2 + std::max(0.0, dot(light, block.normalWorld[i]));
  return signal;
}

// The straight edge of a shadow.
Signal shadowEdge(const Block&, Random& random) {
  const double phi = random.uniform(0.0, 6.28);
  const double offset = random.uniform(-0.7, 0.7);
  const double shadow = random.uniform(0.0, 0.5);
  Signal signal;
  for (int i = 0; i < kBlockPixels; ++i)
    signal[i] = std::cos(phi) * across(i) + std::sin(phi) * down(i) > offset ? 1.0 : shadow;
  return signal;
}

Signal evenLight(const Block&, Random&) {
  Signal signal;
  signal.fill(1.0);
  return signal;
}

// One light sample is found with some probability and then counts for all that were not.
double sampleNoise(double found, Random& random) {
  return random.chance(found) ? -std::log(1.0 - random.uniform()) / found : 0.0;
}

using Light = Signal (*)(const Block&, Random&);

void addLight(Block& block, Light light, Random& random) {
  const bool noisy = random.chance(0.67) || light == evenLight;
  const double brightness = random.logUniform(1e-3, 1e3);
  for (std::size_t c = 0; c < 3; ++c) {
    const Signal signal = light(block, random);
    const double tint = brightness * random.uniform(0.2, 1.0);
    const double found = random.uniform(0.1, 1.0);
    for (std::size_t i = 0; i < kBlockPixels; ++i)
      block.radiance[i][c] = tint * signal[i] * (noisy ? sampleNoise(found, random) : 1.0);
  }
}

}  // namespace

void addLighting(Block& block, Random& random) {
  constexpr Light kLights[] = {smoothLight, lambertLight, shadowEdge, evenLight};
  addLight(block, kLights[random.integer(0, 3)], random);
}

void addGentleLighting(Block& block, Random& random) {
  constexpr Light kLights[] = {smoothLight, wideLight, evenLight};
  addLight(block, kLights[random.integer(0, 2)], random);
}

}  // namespace quell::stress

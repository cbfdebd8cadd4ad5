#include "tests/oracle/demodulation_oracle.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/common/types.h"

namespace quell::tests {
namespace {

constexpr double kFullFactor = 0.01;   // reflectance from which on a channel is filtered entirely
constexpr double kLeastFactor = 1e-6;  // least divisor, reflectance
constexpr double kFloatRounding = 1e-6;

Vector3d cleanFactor(const Vector3d& factor) {
  return factor.unaryExpr(
      [](double f) { return std::isfinite(f) && f > 0.0 ? std::min<double>(f, QUELL_MAX_RADIANCE) : 0.0; });
}

double smoothstep(double t) { return t * t * (3.0 - 2.0 * t); }

// What tints this signal; 1 where the image is absent.
Vector3d colorAt(const MaterialImages& images, int x, int y, int signal) {
  const bool apart = images.signals() == 2;
  Vector3d color = Vector3d::Zero();
  bool any = false;
  const auto add = [&](const io::Image& image, int ofSignal, const Vector3d& dimmed) {
    if (image.empty() || (apart && signal != ofSignal)) return;
    color += cleanFactor(rgbAt(image, x, y)).cwiseProduct(dimmed);
    any = true;
  };
  Vector3d fBeta = Vector3d::Ones();
  for (int c = 0; c < images.fBeta.count; ++c) fBeta[c] = images.fBeta.at(c, x, y);
  add(images.albedo, 0, Vector3d::Ones());
  add(images.glossColor, 1, fBeta);
  return any ? color : Vector3d::Ones();
}

}  // namespace

Vector3d rgbAt(const io::Image& image, int x, int y) {
  Vector3d rgb;
  for (int c = 0; c < 3; ++c)
    rgb[c] = image.channels == 1 ? image.at(x, y, 0) : c < image.channels ? image.at(x, y, c) : 0.0f;
  return rgb;
}

Material materialAt(const MaterialImages& images, int x, int y, int signal) {
  Material material;
  const Vector3d radiance = rgbAt(signal == 0 ? images.radiance : images.glossyRadiance, x, y);
  const bool emits = signal == 0 && !images.emission.empty();
  Vector3d emission = emits ? rgbAt(images.emission, x, y) : Vector3d::Zero();
  if (emission.allFinite()) emission = emission.cwiseMax(0.0).cwiseMin(double(QUELL_MAX_RADIANCE));
  material.finite = radiance.allFinite() && emission.allFinite();
  if (emission.allFinite()) material.emission = emission;
  const Vector3d light = images.demodulated ? radiance : Vector3d(radiance - emission);
  if (material.finite) material.signal = light.cwiseMax(0.0).cwiseMin(QUELL_MAX_RADIANCE);
  const Vector3d color = colorAt(images, x, y, signal);
  if (images.demodulated) {
    material.tint = color;
  } else if (images.divide) {
    material.factor = color;
  }
  return material;
}

Vector3d filteredShare(const Vector3d& factor) {
  return factor.unaryExpr(
      [](double f) { return f < kLeastFactor ? 0.0 : smoothstep(std::clamp(f / kFullFactor, 0.0, 1.0)); });
}

Irradiance demodulate(const Material& material) {
  const Vector3d share = filteredShare(material.factor);
  const Vector3d divided =
      material.signal.cwiseQuotient(material.factor.cwiseMax(kLeastFactor)).cwiseMin(QUELL_MAX_RADIANCE);
  const double best = share.maxCoeff();
  if (best == 0.0) return {Vector3d::Zero(), 0.0};
  // A channel that tells nothing about the light takes the mean of those that do.
  const double grey = divided.dot(share) / share.sum();
  return {Vector3d::Constant(grey) + (divided - Vector3d::Constant(grey)).cwiseProduct(share) / best, best};
}

bool factorUndecided(const Material& material) {
  return ((material.factor.array() - kLeastFactor).abs() < kFloatRounding * kLeastFactor).any();
}

}  // namespace quell::tests

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

}  // namespace

Vector3d rgbAt(const io::Image& image, int x, int y) {
  Vector3d rgb;
  for (int c = 0; c < 3; ++c)
    rgb[c] = image.channels == 1 ? image.at(x, y, 0) : c < image.channels ? image.at(x, y, c) : 0.0f;
  return rgb;
}

Material materialAt(const MaterialImages& images, int x, int y) {
  Material material;
  const Vector3d radiance = rgbAt(images.radiance, x, y);
  const Vector3d emission = images.emission.empty() ? Vector3d::Zero() : rgbAt(images.emission, x, y);
  material.finite = radiance.allFinite() && emission.allFinite();
  if (emission.allFinite()) material.emission = emission;
  const Vector3d light = images.demodulated ? radiance : Vector3d(radiance - emission);
  if (material.finite) material.signal = light.cwiseMax(0.0).cwiseMin(QUELL_MAX_RADIANCE);
  if (!images.albedo.empty() || !images.glossColor.empty()) material.factor.setZero();
  if (!images.albedo.empty()) material.factor += cleanFactor(rgbAt(images.albedo, x, y));
  if (!images.glossColor.empty()) material.factor += cleanFactor(rgbAt(images.glossColor, x, y));
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

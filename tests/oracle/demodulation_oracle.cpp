#include "tests/oracle/demodulation_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernels/common/types.h"

namespace quell::tests {
namespace {

constexpr double kLeastFactor = 0.01, kMostFactor = 2.0;  // reflectance that light is divided by
constexpr double kDielectricReflectance = 0.04, kSureExcess = 0.1;
constexpr double kNoiselessDifference = 0.01;  // share of the brightest channel
constexpr int kNoiselessNeighbours = 2;        // of four
constexpr double kFloatRounding = 1e-6;

Vector3d cleanFactor(const Vector3d& factor) {
  return factor.unaryExpr(
      [](double f) { return std::isfinite(f) && f > 0.0 ? std::min<double>(f, QUELL_MAX_RADIANCE) : 0.0; });
}

// What there is of a gloss colour that exceeds 1 together with albedo: F0 of it.
Vector3d shareOfGloss(const Vector3d& albedo, const Vector3d& gloss, const Vector3d& f0) {
  const double excess = (albedo + gloss).maxCoeff() - 1.0;
  return Vector3d::Ones() - std::clamp(excess / kSureExcess, 0.0, 1.0) * (Vector3d::Ones() - f0);
}

// F0 where it is not in F_beta.
Vector3d f0At(const MaterialImages& images, int x, int y) {
  if (images.f0.empty() || images.fBeta.count > 0) return Vector3d::Constant(kDielectricReflectance);
  return cleanFactor(rgbAt(images.f0, x, y)).cwiseMin(1.0);
}

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
  if (!apart && !images.demodulated && !images.albedo.empty() && !images.glossColor.empty())
    fBeta = fBeta.cwiseProduct(shareOfGloss(
        color, cleanFactor(rgbAt(images.glossColor, x, y)).cwiseProduct(fBeta), f0At(images, x, y)));
  add(images.glossColor, 1, fBeta);
  return any ? color : Vector3d::Ones();
}

// Whether emitters are to be found by their colour.
bool emittersAreUnknown(const MaterialImages& images) {
  return images.emission.empty() && images.divide && !images.demodulated;
}

// Whether the nearest pixels have the same light.
bool isNoiseless(const io::Image& radiance, int x, int y, bool& undecided) {
  const Vector3d light = rgbAt(radiance, x, y).cwiseMax(0.0).cwiseMin(double(QUELL_MAX_RADIANCE));
  const double most = kNoiselessDifference * light.maxCoeff();
  int alike = 0;
  for (const auto& [dx, dy] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
    if (x + dx < 0 || x + dx >= radiance.width || y + dy < 0 || y + dy >= radiance.height) continue;
    const Vector3d difference = rgbAt(radiance, x + dx, y + dy) - light;
    if (!difference.allFinite()) continue;
    const double largest = difference.cwiseAbs().maxCoeff();
    undecided = undecided || std::abs(largest - most) <= kFloatRounding * light.maxCoeff();
    if (largest <= most) ++alike;
  }
  return light.maxCoeff() > 0.0 && alike >= kNoiselessNeighbours;
}

// Bounds of what divides a signal, and whether it is to be filtered at all.
void divide(Material& material, const MaterialImages& images, const Vector3d& factor, int x, int y,
            int signal) {
  for (std::size_t c = 0; c < 3; ++c) {
    const double channel = factor[Eigen::Index(c)];
    material.weak[c] = channel < kLeastFactor;
    material.undecided =
        material.undecided || std::abs(channel - kLeastFactor) < kFloatRounding * kLeastFactor;
  }
  material.fillsWeak = images.signals() == 2 && !material.vanishes();
  if (!material.vanishes()) {
    for (Eigen::Index c = 0; c < 3; ++c)
      material.divisor[c] =
          std::min(material.weak[std::size_t(c)] ? factor.maxCoeff() : factor[c], kMostFactor);
    return;
  }
  const bool dark = material.signal.maxCoeff() == 0.0;
  material.faint = images.signals() == 2 && (dark || factor.maxCoeff() > 0.0);
  material.emits = material.emission.maxCoeff() > 0.0;
  if (!material.emits && signal == 0 && emittersAreUnknown(images))
    material.emits = isNoiseless(images.radiance, x, y, material.undecided);
}

}  // namespace

Vector3d rgbAt(const io::Image& image, int x, int y) {
  Vector3d rgb;
  for (int c = 0; c < 3; ++c)
    rgb[c] = image.channels == 1 ? image.at(x, y, 0) : c < image.channels ? image.at(x, y, c) : 0.0f;
  return rgb;
}

Vector3d Material::irradiance() const {
  Vector3d value = signal.cwiseQuotient(divisor);
  if (!fillsWeak) return value;
  double sum = 0.0, count = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    sum += weak[c] ? 0.0 : value[Eigen::Index(c)];
    count += weak[c] ? 0.0 : 1.0;
  }
  for (std::size_t c = 0; c < 3; ++c)
    if (weak[c]) value[Eigen::Index(c)] = sum / count;
  return value;
}

Material materialAt(const MaterialImages& images, int x, int y, int signal) {
  Material material;
  const Vector3d radiance = rgbAt(signal == 0 ? images.radiance : images.glossyRadiance, x, y);
  const bool emits = signal == 0 && !images.emission.empty();
  Vector3d emission = emits ? rgbAt(images.emission, x, y) : Vector3d::Zero();
  if (emission.allFinite()) emission = emission.cwiseMax(0.0).cwiseMin(double(QUELL_MAX_RADIANCE));
  material.finite = radiance.allFinite() && emission.allFinite();
  // What is added back is no more than what was there.
  if (emission.allFinite() && radiance.allFinite() && !images.demodulated)
    emission = emission.cwiseMin(radiance.cwiseMax(0.0));
  if (emission.allFinite()) material.emission = emission;
  const Vector3d light = images.demodulated ? radiance : Vector3d(radiance - emission);
  if (material.finite) material.signal = light.cwiseMax(0.0).cwiseMin(QUELL_MAX_RADIANCE);
  const Vector3d color = colorAt(images, x, y, signal);
  if (images.demodulated) {
    material.tint = color;
  } else if (images.divide) {
    divide(material, images, color, x, y, signal);
  }
  return material;
}

}  // namespace quell::tests

#include "host/check/noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>

#include "host/check/view.hpp"

namespace quell::check {
namespace {

/// Pixels that are looked at, on a regular grid, and the least of them that prove something.
constexpr double kMostPixels = 32768.0;
constexpr std::size_t kLeastPixels = 256;
/// Neighbours up to this far, in pixels, and the least of the 25 that must show the same surface.
constexpr int kReach = 2;
constexpr int kLeastNeighbours = 20;
/// Least cosine between normals of one surface, and least luminance of albedo and gloss colour.
constexpr double kSameNormal = 0.95, kLeastFactor = 0.02;
/// Median distance from the mean, as a share of it, below which it is not noise.
constexpr double kLeastNoise = 0.1;
/// Surfaces have moved by less than this, pixels, where history has the same pixel's noise.
constexpr double kStillPx = 0.5;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

int gridStep(const Frame& frame) {
  return int(std::ceil(std::sqrt(double(frame.width()) * frame.height() / kMostPixels)));
}

template <class Work>
void forEachOnGrid(const Frame& frame, const Work& work) {
  const int step = gridStep(frame);
  for (int y = kReach; y < frame.height() - kReach; y += step)
    for (int x = kReach; x < frame.width() - kReach; x += step) work(x, y);
}

bool hasSurface(const Frame& frame, int x, int y) {
  const glm::dvec3 normal = vectorAt(frame.normalWorld, x, y);
  return isFinite(normal) && !isZero(normal);
}

/// Luminance without texture; NaN for what is black, background or broken.
double irradianceAt(const Frame& frame, int x, int y) {
  if (!hasSurface(frame, x, y)) return kNone;
  if (frame.demodulated) return luminanceAt(frame.radiance, x, y);
  const double light = luminanceAt(frame.radiance, x, y) - luminanceAt(frame.emission, x, y);
  const double factor = luminanceAt(frame.albedo, x, y) + luminanceAt(frame.glossColor, x, y);
  return factor >= kLeastFactor ? std::max(light, 0.0) / factor : kNone;
}

/// Distance from the mean of the neighbours that show the same surface, as a share of it, in [-1, 1]; NaN where too few do.
double residualAt(const Frame& frame, int x, int y) {
  const double here = irradianceAt(frame, x, y);
  if (!std::isfinite(here)) return kNone;
  const glm::dvec3 normal = glm::normalize(vectorAt(frame.normalWorld, x, y));
  double sum = 0.0;
  int neighbours = 0;
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const double there = irradianceAt(frame, x + dx, y + dy);
      if (!std::isfinite(there)) continue;
      if (glm::dot(normal, glm::normalize(vectorAt(frame.normalWorld, x + dx, y + dy))) < kSameNormal)
        continue;
      sum += there;
      ++neighbours;
    }
  }
  return neighbours >= kLeastNeighbours && sum > 0.0 ? std::clamp(here * neighbours / sum - 1.0, -1.0, 1.0)
                                                     : kNone;
}

}  // namespace

std::optional<double> noiseCorrelation(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> sizes;
  double sumA = 0.0, sumB = 0.0, squareA = 0.0, squareB = 0.0, product = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (!(std::isfinite(a[i]) && std::isfinite(b[i]))) continue;
    sizes.push_back(std::abs(a[i]));
    sumA += a[i];
    sumB += b[i];
    squareA += a[i] * a[i];
    squareB += b[i] * b[i];
    product += a[i] * b[i];
  }
  if (sizes.size() < kLeastPixels) return std::nullopt;
  const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  if (*middle < kLeastNoise) return std::nullopt;
  const double count = double(sizes.size());
  const double varianceA = squareA - sumA * sumA / count, varianceB = squareB - sumB * sumB / count;
  return (product - sumA * sumB / count) / std::sqrt(varianceA * varianceB);
}

std::vector<double> noiseResiduals(const Frame& frame) {
  std::vector<double> residuals;
  const bool known = frame.albedo.present() || frame.glossColor.present();
  forEachOnGrid(frame, [&](int x, int y) { residuals.push_back(known ? residualAt(frame, x, y) : kNone); });
  return residuals;
}

bool isStill(const Frame& frame) {
  if (!frame.positionWorld.present()) return false;
  double surfaces = 0.0, still = 0.0;
  forEachOnGrid(frame, [&](int x, int y) {
    if (!hasSurface(frame, x, y)) return;
    surfaces += 1.0;
    const auto before = project(frame.camera.worldToClipPrev, vectorAt(frame.positionWorld, x, y),
                                {frame.width(), frame.height()});
    still += before && std::hypot(before->x - 0.5 - x, before->y - 0.5 - y) < kStillPx;
  });
  return still > 0.5 * surfaces;
}

}  // namespace quell::check

#include "host/cli/common/noise_watch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "host/cli/common/pixels.hpp"

namespace quell::cli {
namespace {

/// Pairs of frames after which nothing more is expected.
constexpr int kPairs = 3;
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
/// Correlation from which on noise is the same. Measured: at most 0.13 for seeds of their own (480x270 path-traced with one
/// sample; texture and shadows), 0.81 and more for one seed, under a moving camera, too.
constexpr double kFrozen = 0.5;
/// Surfaces have moved by less than this, pixels, where history has the same pixel's noise.
constexpr double kStillPx = 0.5;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

int gridStep(const io::FrameData& frame) {
  return int(std::ceil(std::sqrt(double(frame.radiance.width) * frame.radiance.height / kMostPixels)));
}

template <class Work>
void forEachOnGrid(const io::FrameData& frame, const Work& work) {
  const int step = gridStep(frame);
  for (int y = kReach; y < frame.radiance.height - kReach; y += step)
    for (int x = kReach; x < frame.radiance.width - kReach; x += step) work(x, y);
}

bool hasSurface(const io::FrameData& frame, int x, int y) {
  const glm::dvec3 normal = vectorAt(frame.normalWorld, x, y);
  return isFinite(normal) && normal != glm::dvec3(0.0);
}

/// Luminance without texture; NaN for what is black, background or broken.
double irradianceAt(const io::FrameData& frame, int x, int y) {
  if (!hasSurface(frame, x, y)) return kNone;
  double light = luminance(vectorAt(frame.radiance, x, y));
  if (frame.demodulated) return light;
  if (!frame.emission.empty()) light -= luminance(vectorAt(frame.emission, x, y));
  double factor = 0.0;
  for (const io::Image* image : {&frame.albedo, &frame.glossColor})
    if (!image->empty()) factor += luminance(vectorAt(*image, x, y));
  return factor >= kLeastFactor ? std::max(light, 0.0) / factor : kNone;
}

/// Distance from the mean of the neighbours that show the same surface, as a share of it, in [-1, 1]; NaN where too few do.
double residualAt(const io::FrameData& frame, int x, int y) {
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

/// Nothing if there are too few pixels, or no noise to speak of.
std::optional<double> correlationOf(const std::vector<double>& a, const std::vector<double>& b) {
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

/// Pixels between where a surface is and where the matrices say that it was; infinite behind the camera.
double stepPx(const io::FrameData& frame, int x, int y) {
  const glm::dvec3 p = vectorAt(frame.positionWorld, x, y);
  const auto row = [&](std::size_t r) {
    const double* m = &frame.camera.worldToClipPrev[4 * r];
    return m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
  };
  const double width = frame.radiance.width, height = frame.radiance.height, w = row(3);
  if (!(w > 0.0)) return std::numeric_limits<double>::infinity();
  return std::hypot((0.5 + 0.5 * row(0) / w) * width - 0.5 - x, (0.5 - 0.5 * row(1) / w) * height - 0.5 - y);
}

/// Whether most surfaces are where they were before.
bool isStill(const io::FrameData& frame) {
  double surfaces = 0.0, still = 0.0;
  forEachOnGrid(frame, [&](int x, int y) {
    if (!hasSurface(frame, x, y)) return;
    surfaces += 1.0;
    still += stepPx(frame, x, y) < kStillPx;
  });
  return still > 0.5 * surfaces;
}

}  // namespace

void NoiseWatch::compare(const io::FrameData& frame) {
  std::vector<double> residuals;
  forEachOnGrid(frame, [&](int x, int y) { residuals.push_back(residualAt(frame, x, y)); });
  if (const auto correlation = correlationOf(m_last, residuals)) {
    m_result.correlation = *correlation;
    m_result.frozen = m_result.frozen || *correlation > kFrozen;
    ++m_pairs;
  }
  m_last = std::move(residuals);
}

NoiseWatch::Result NoiseWatch::add(const io::FrameData& frame) {
  if (frame.albedo.empty() && frame.glossColor.empty()) return {};
  const bool follows = m_lastNumber && frame.number == *m_lastNumber + 1;
  if (!follows) m_last.clear();
  m_lastNumber = frame.number;
  if (!m_result.frozen && m_pairs < kPairs) compare(frame);
  m_result.repeats = m_result.frozen && isStill(frame);
  return m_result;
}

}  // namespace quell::cli

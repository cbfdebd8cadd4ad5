#include "host/metrics/motion_compensated.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "host/metrics/display_encoding.hpp"
#include "host/metrics/image_checks.hpp"

namespace quell::metrics {
namespace {

using Vector = std::array<double, 3>;

Vector at(const io::Image& image, int x, int y) {
  return {double(image.at(x, y, 0)), double(image.at(x, y, 1)), double(image.at(x, y, 2))};
}

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Pixel index in the frame before and clip.w there; nothing behind the camera.
struct Place {
  double x, y, clipW;
};

std::optional<Place> reproject(const Matrix4& worldToClip, const Vector& p, int width, int height) {
  const auto row = [&](std::size_t r) {
    const double* m = &worldToClip[4 * r];
    return m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
  };
  const double w = row(3);
  if (!(w > 0.0)) return std::nullopt;
  return Place{(0.5 + 0.5 * row(0) / w) * width - 0.5, (0.5 - 0.5 * row(1) / w) * height - 0.5, w};
}

double lumaAt(const io::Image& image, int x, int y) {
  const Vector c = at(image, x, y);
  return luma(c[0], c[1], c[2]);
}

// Bilinear luma of the frame before, if all of its taps show the surface.
std::optional<double> lumaBefore(const TrackedFrame& before, const Place& place, const Vector& position,
                                 const Vector& normal) {
  const double left = std::floor(place.x), top = std::floor(place.y);
  double sum = 0.0;
  for (int tap = 0; tap < 4; ++tap) {
    const int x = int(left) + tap % 2, y = int(top) + tap / 2;
    const double weight = (tap % 2 == 1 ? place.x - left : 1.0 - (place.x - left)) *
                          (tap / 2 == 1 ? place.y - top : 1.0 - (place.y - top));
    if (weight == 0.0) continue;
    if (x < 0 || y < 0 || x >= before.encoded.width || y >= before.encoded.height) return std::nullopt;
    const Vector tapPosition = at(before.positionWorld, x, y);
    const Vector step = {tapPosition[0] - position[0], tapPosition[1] - position[1],
                         tapPosition[2] - position[2]};
    const double limit = kSameSurfaceShare * place.clipW;
    if (!(dot(step, step) <= limit * limit)) return std::nullopt;
    if (!(dot(at(before.normalWorld, x, y), normal) >= kSameSurfaceCosine)) return std::nullopt;
    sum += weight * lumaAt(before.encoded, x, y);
  }
  return sum;
}

}  // namespace

void MotionCompensatedErrorMeter::add(TrackedFrame frame) {
  for (const io::Image* image : {&frame.normalWorld, &frame.positionWorld})
    requireComparable(*image, frame.encoded, "motion-compensated temporal error");
  if (!m_last.encoded.empty()) {
    requireComparable(frame.encoded, m_last.encoded, "motion-compensated temporal error");
    for (int y = 0; y < frame.encoded.height; ++y) {
      for (int x = 0; x < frame.encoded.width; ++x) {
        const Vector normal = at(frame.normalWorld, x, y), position = at(frame.positionWorld, x, y);
        if (!(dot(normal, normal) > 0.0)) continue;
        const auto place =
            reproject(frame.camera.worldToClipPrev, position, frame.encoded.width, frame.encoded.height);
        if (!place || !(std::abs(place->x) < 1e6 && std::abs(place->y) < 1e6)) continue;
        if (const auto before = lumaBefore(m_last, *place, position, normal)) {
          m_sum += std::abs(lumaAt(frame.encoded, x, y) - *before);
          m_count += 1.0;
        }
      }
    }
  }
  m_last = std::move(frame);
}

std::optional<double> MotionCompensatedErrorMeter::mean() const {
  if (m_count == 0.0) return std::nullopt;
  return m_sum / m_count;
}

}  // namespace quell::metrics

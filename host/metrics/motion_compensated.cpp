#include "host/metrics/motion_compensated.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <quell/error.hpp>
#include <string>
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

double clipRow(const Matrix4& worldToClip, std::size_t row, const Vector& p) {
  const double* m = &worldToClip[4 * row];
  return m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
}

// Pixel index in the frame before, where history lives on pixel centres (quell::Camera), and clip.w there; nothing
// behind the camera.
struct Place {
  double x, y, clipW;
};

std::optional<Place> reproject(const Camera& camera, const Vector& p, int width, int height) {
  const auto row = [&](std::size_t r) { return clipRow(camera.worldToClipPrev, r, p); };
  const double w = row(3);
  if (!(w > 0.0)) return std::nullopt;
  return Place{(0.5 + 0.5 * row(0) / w) * width - 0.5 - camera.jitterPx[0],
               (0.5 - 0.5 * row(1) / w) * height - 0.5 - camera.jitterPx[1], w};
}

double lumaAt(const io::Image& image, int x, int y) {
  const Vector c = at(image, x, y);
  return luma(c[0], c[1], c[2]);
}

// A pixel of the newest frame, and where its surface was before.
struct Point {
  Vector position, normal;
  Place place;
  bool moved = false;  // other than by the camera
  float objectId = 0.0f;
};

bool sameSurface(const TrackedFrame& before, const Point& point, int x, int y) {
  if (!(dot(at(before.normalWorld, x, y), point.normal) >= kSameSurfaceCosine)) return false;
  const Vector position = at(before.positionWorld, x, y);
  if (point.moved) {
    const double change = clipRow(before.camera.worldToClip, 3, position) - point.place.clipW;
    return before.objectId.at(x, y, 0) == point.objectId &&
           std::abs(change) <= kMovedDepthShare * point.place.clipW;
  }
  const Vector step = {position[0] - point.position[0], position[1] - point.position[1],
                       position[2] - point.position[2]};
  const double limit = kSameSurfaceShare * point.place.clipW;
  return dot(step, step) <= limit * limit;
}

// Bilinear luma of the frame before, if all of its taps show the surface.
std::optional<double> lumaBefore(const TrackedFrame& before, const Point& point) {
  const Place& place = point.place;
  if (!(std::abs(place.x) < 1e6 && std::abs(place.y) < 1e6)) return std::nullopt;
  const double left = std::floor(place.x), top = std::floor(place.y);
  double sum = 0.0;
  for (int tap = 0; tap < 4; ++tap) {
    const int x = int(left) + tap % 2, y = int(top) + tap / 2;
    const double weight = (tap % 2 == 1 ? place.x - left : 1.0 - (place.x - left)) *
                          (tap / 2 == 1 ? place.y - top : 1.0 - (place.y - top));
    if (weight == 0.0) continue;
    if (x < 0 || y < 0 || x >= before.encoded.width || y >= before.encoded.height) return std::nullopt;
    if (!sameSurface(before, point, x, y)) return std::nullopt;
    sum += weight * lumaAt(before.encoded, x, y);
  }
  return sum;
}

// Nothing for background and for what was behind the camera.
std::optional<Point> pointAt(const TrackedFrame& frame, int x, int y) {
  Point point{at(frame.positionWorld, x, y), at(frame.normalWorld, x, y), {}};
  if (!(dot(point.normal, point.normal) > 0.0)) return std::nullopt;
  const auto place = reproject(frame.camera, point.position, frame.encoded.width, frame.encoded.height);
  if (!place) return std::nullopt;
  point.place = *place;
  if (frame.motion.empty() || frame.objectId.empty()) return point;
  const double movedX = x + double(frame.motion.at(x, y, 0)), movedY = y + double(frame.motion.at(x, y, 1));
  point.moved = !(std::hypot(movedX - place->x, movedY - place->y) <= kMovedPx);
  if (!point.moved) return point;
  point.place = {movedX, movedY, place->clipW};
  point.objectId = frame.objectId.at(x, y, 0);
  return point;
}

void requireChannels(const io::Image& image, int channels, const TrackedFrame& frame, const char* name) {
  if (image.empty()) return;
  if (image.channels != channels || image.width != frame.encoded.width ||
      image.height != frame.encoded.height)
    throw Error(ErrorCode::InvalidArgument,
                {"motion-compensated temporal error", name,
                 std::to_string(channels) + " channels and the size of the picture",
                 std::to_string(image.width) + "x" + std::to_string(image.height) + ", " +
                     std::to_string(image.channels) + " channels"});
}

}  // namespace

void MotionCompensatedErrorMeter::add(TrackedFrame frame) {
  for (const io::Image* image : {&frame.normalWorld, &frame.positionWorld})
    requireComparable(*image, frame.encoded, "motion-compensated temporal error");
  requireChannels(frame.motion, 2, frame, "motion");
  requireChannels(frame.objectId, 1, frame, "objectId");
  if (!m_last.encoded.empty() && !frame.afterCut) {
    requireComparable(frame.encoded, m_last.encoded, "motion-compensated temporal error");
    if (m_last.objectId.empty()) frame.objectId = io::Image();
    for (int y = 0; y < frame.encoded.height; ++y) {
      for (int x = 0; x < frame.encoded.width; ++x) {
        const auto point = pointAt(frame, x, y);
        if (!point) continue;
        if (const auto before = lumaBefore(m_last, *point)) {
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

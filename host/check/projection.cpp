#include "host/check/projection.hpp"

#include <cmath>
#include <limits>

namespace quell::check {
namespace {

/// Pixels between those that are looked at for the mean, along each axis.
constexpr int kStride = 5;
/// Farther than a pixel filter reaches: a camera that does not fit is another matter.
constexpr double kFilterPx = 2.0;

}  // namespace

std::vector<glm::dvec2> offsetsPx(const Context& context, const Matrix4& worldToClip) {
  const auto& jitter = context.now.camera.jitterPx;
  std::vector<glm::dvec2> offsets;
  offsets.reserve(context.surfaces().size());
  for (const Surface& surface : context.surfaces()) {
    const glm::dvec2 ray(surface.x + 0.5 + jitter[0], surface.y + 0.5 + jitter[1]);
    const auto place = project(worldToClip, surface.position, context.size);
    offsets.push_back(place ? *place - ray : glm::dvec2(std::numeric_limits<double>::infinity()));
  }
  return offsets;
}

std::vector<double> lengthsOf(const std::vector<glm::dvec2>& offsets) {
  std::vector<double> lengths;
  lengths.reserve(offsets.size());
  for (const glm::dvec2& offset : offsets) lengths.push_back(std::hypot(offset.x, offset.y));
  return lengths;
}

glm::dvec2 medianOf(const std::vector<glm::dvec2>& offsets) {
  std::vector<double> x, y;
  for (const glm::dvec2& offset : offsets) {
    x.push_back(offset.x);
    y.push_back(offset.y);
  }
  return {median(std::move(x)), median(std::move(y))};
}

double rayOffsetPx(const Frame& frame) {
  if (!frame.positionWorld.present()) return 0.0;
  const Size size{frame.width(), frame.height()};
  double sum = 0.0;
  int count = 0;
  for (int y = kStride / 2; y < size.height; y += kStride) {
    for (int x = kStride / 2; x < size.width; x += kStride) {
      if (isZero(vectorAt(frame.normalWorld, x, y))) continue;
      const auto place = project(frame.camera.worldToClip, vectorAt(frame.positionWorld, x, y), size);
      if (!place) continue;
      const double offset = std::hypot(place->x - (x + 0.5 + frame.camera.jitterPx[0]),
                                       place->y - (y + 0.5 + frame.camera.jitterPx[1]));
      if (!(offset <= kFilterPx)) continue;
      sum += offset;
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace quell::check

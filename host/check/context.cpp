#include "host/check/context.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace quell::check {
namespace {

/// Of the grid: 4 of 5 pixels at 640x480, every third in x and y at 1920x1080.
constexpr double kMostPixels = 1 << 18;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

int gridStep(Size size) { return int(std::ceil(std::sqrt(double(size.width) * size.height / kMostPixels))); }

glm::dvec3 positionIn(const Frame& frame, const std::optional<View>& view, Size size, int x, int y) {
  if (frame.positionWorld.present()) {
    const glm::dvec3 position = vectorAt(frame.positionWorld, x, y);
    return isFinite(position) && !isZero(position) ? position : glm::dvec3(kNan);
  }
  if (!frame.viewDepth.present() || !view) return glm::dvec3(kNan);
  return positionFromDepth(frame.camera, *view, size, x, y, double(frame.viewDepth.at(x, y, 0)));
}

}  // namespace

glm::dvec3 positionFromDepth(const Camera& camera, const View& view, Size size, int x, int y, double depth) {
  if (!(std::abs(depth) > 0.0) || !view.perspective) return glm::dvec3(kNan);
  const glm::dvec2 pixel(x + 0.5 + camera.jitterPx[0], y + 0.5 + camera.jitterPx[1]);
  return view.eye + depth * rayThrough(camera.worldToClip, view, pixel, size);
}

Context::Context(const Frame& current, const Frame* last)
    : now(current),
      before(last),
      size{current.width(), current.height()},
      view(viewOf(current.camera.worldToClip)),
      m_step(gridStep(size)),
      m_viewBefore(last == nullptr ? std::nullopt : viewOf(last->camera.worldToClip)) {
  forEach([&](int x, int y) {
    const glm::dvec3 normal = vectorAt(now.normalWorld, x, y), position = positionAt(x, y);
    if (isFinite(normal) && !isZero(normal) && isFinite(position))
      m_surfaces.push_back({x, y, position, normal});
  });
}

glm::dvec3 Context::positionAt(int x, int y) const { return positionIn(now, view, size, x, y); }
glm::dvec3 Context::positionBefore(int x, int y) const {
  return positionIn(*before, m_viewBefore, size, x, y);
}

Map Context::mapOf(const std::function<double(int x, int y)>& value) const {
  Map map{
      (size.width + m_step - 1 - m_step / 2) / m_step, (size.height + m_step - 1 - m_step / 2) / m_step, {}};
  map.values.reserve(std::size_t(map.width) * std::size_t(map.height));
  forEach([&](int x, int y) { map.values.push_back(float(std::clamp(value(x, y), 0.0, 1.0))); });
  return map;
}

Map Context::mapOf(const std::vector<double>& ofSurfaces) const {
  std::size_t next = 0;
  return mapOf([&](int x, int y) {
    if (next >= m_surfaces.size() || m_surfaces[next].x != x || m_surfaces[next].y != y) return 0.0;
    return ofSurfaces[next++];
  });
}

double median(std::vector<double> values) {
  if (values.empty()) return kNan;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, value);
  return text;
}

std::string percent(double share) { return fixed(100.0 * share, share < 0.1 ? 1 : 0) + " %"; }

}  // namespace quell::check

#include "host/io/ray_depth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "host/io/depth_kind.hpp"
#include "host/io/least_median.hpp"
#include "host/io/least_squares.hpp"
#include "host/io/multilayer_camera.hpp"

namespace quell::io {
namespace {

constexpr std::size_t kUnknowns = 5;
/// Distances that differ from the eye's by more than so many medians count for nothing the next time.
constexpr double kNearMedians = 4.0;
constexpr int kRefinements = 2;
/// Distances of positions may be means over a pixel, and rounded to halves: a factor, and in extents of the scene.
constexpr double kMostApart = 1.1, kRounding = 0.01;

using Vector3 = std::array<double, 3>;

struct Surface {
  int x, y;
  Vector3 position;  // from the mean of all, in units of their extent
  double distance;
  bool counts = true;
};

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector3 minus(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector3 unit(const Vector3& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}
Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Divides by the extent of the positions, which it returns; 0 where they have none.
double normalize(std::vector<Surface>& surfaces) {
  Vector3 mean{};
  for (const Surface& surface : surfaces)
    for (std::size_t i = 0; i < 3; ++i) mean[i] += surface.position[i] / double(surfaces.size());
  double squares = 0.0;
  for (Surface& surface : surfaces) {
    surface.position = minus(surface.position, mean);
    squares += dot(surface.position, surface.position) / double(surfaces.size());
  }
  const double extent = std::sqrt(squares);
  for (Surface& surface : surfaces) {
    for (double& component : surface.position) component /= extent;
    surface.distance /= extent;
  }
  return extent;
}

/// No two distances differ by more than their positions do: compared with the surface of the median distance.
void leaveOutImpossible(std::vector<Surface>& surfaces) {
  std::vector<Surface> sorted = surfaces;
  const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end(),
                   [](const Surface& a, const Surface& b) { return a.distance < b.distance; });
  for (Surface& s : surfaces) {
    const Vector3 apart = minus(s.position, middle->position);
    s.counts =
        std::abs(s.distance - middle->distance) <= kMostApart * std::sqrt(dot(apart, apart)) + kRounding;
  }
}

/// |p - eye| = distance + start is linear in the eye, the start, and start^2 - |eye|^2.
std::optional<Vector3> findEye(std::vector<Surface>& surfaces) {
  leaveOutImpossible(surfaces);
  std::optional<Vector3> eye;
  for (int round = 0; round <= kRefinements; ++round) {
    LeastSquares<kUnknowns> squares;
    for (const Surface& s : surfaces)
      if (s.counts)
        squares.add({2.0 * s.position[0], 2.0 * s.position[1], 2.0 * s.position[2], 2.0 * s.distance, 1.0,
                     dot(s.position, s.position) - s.distance * s.distance});
    const auto found = squares.solve();
    if (!found) return std::nullopt;
    eye = Vector3{(*found)[0], (*found)[1], (*found)[2]};
    std::vector<double> errors;
    const auto error = [&](const Surface& s) {
      const Vector3 ray = minus(s.position, *eye);
      return std::abs(std::sqrt(dot(ray, ray)) - s.distance - (*found)[3]);
    };
    for (const Surface& s : surfaces) errors.push_back(error(s));
    const double middle = middleValue(std::move(errors));
    for (Surface& s : surfaces) s.counts = error(s) <= kNearMedians * middle;
  }
  return eye;
}

/// The row w for which ndc * (w . ray) is linear in the ray: the mean ray plus something across it, found once by columns
/// and once by lines.
std::optional<Vector3> findAxis(const std::vector<Surface>& surfaces, const Vector3& eye, int width,
                                int height) {
  Vector3 mean{};
  for (const Surface& s : surfaces) {
    const Vector3 ray = unit(minus(s.position, eye));
    for (std::size_t i = 0; i < 3 && s.counts; ++i) mean[i] += ray[i];
  }
  mean = unit(mean);
  const Vector3 right = unit(cross(mean, std::abs(mean[2]) < 0.9 ? Vector3{0, 0, 1} : Vector3{0, 1, 0}));
  const Vector3 up = cross(right, mean);
  Vector3 axis = mean;
  for (const bool columns : {true, false}) {
    LeastSquares<kUnknowns> squares;
    for (const Surface& s : surfaces) {
      if (!s.counts) continue;
      const Vector3 ray = unit(minus(s.position, eye));
      const double ndc = columns ? (2.0 * s.x + 1.0) / width - 1.0 : 1.0 - (2.0 * s.y + 1.0) / height;
      squares.add(
          {ray[0], ray[1], ray[2], -ndc * dot(right, ray), -ndc * dot(up, ray), ndc * dot(mean, ray)});
    }
    const auto found = squares.solve();
    if (!found) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) axis[i] += 0.5 * ((*found)[3] * right[i] + (*found)[4] * up[i]);
  }
  return unit(axis);
}

}  // namespace

std::optional<Image> viewDepthFromRays(const Image& positionWorld, const Image& rayDepth) {
  std::vector<Surface> surfaces;
  for (int y = 0; y < rayDepth.height; ++y)
    for (int x = 0; x < rayDepth.width; ++x) {
      const double distance = double(rayDepth.at(x, y, 0));
      const Vector3 p = {double(positionWorld.at(x, y, 0)), double(positionWorld.at(x, y, 1)),
                         double(positionWorld.at(x, y, 2))};
      if (distance > 0.0 && distance < double(kSkyDepth) && std::isfinite(dot(p, p)))
        surfaces.push_back({x, y, p, distance});
    }
  if (surfaces.size() <= kUnknowns) return std::nullopt;
  const double extent = normalize(surfaces);
  if (!(extent > 0.0)) return std::nullopt;
  const auto eye = findEye(surfaces);
  const auto axis = eye ? findAxis(surfaces, *eye, rayDepth.width, rayDepth.height) : std::nullopt;
  if (!axis) return std::nullopt;
  Image depth(rayDepth.width, rayDepth.height, 1, kNoSurfaceDepth);
  for (const Surface& s : surfaces)
    if (const double view = dot(minus(s.position, *eye), *axis) * extent; view > 0.0)
      depth.at(s.x, s.y, 0) = float(view);
  return depth;
}

}  // namespace quell::io

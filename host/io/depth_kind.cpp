#include "host/io/depth_kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <quell/error.hpp>

#include "host/io/file_error.hpp"
#include "host/io/multilayer_camera.hpp"

namespace quell::io {
namespace {

using Vector3 = std::array<double, 3>;

struct NamedKind {
  DepthKind kind;
  const char* name;
};
constexpr NamedKind kKinds[] = {{DepthKind::View, "view"},
                                {DepthKind::Ray, "ray"},
                                {DepthKind::Hyperbolic, "hyperbolic"},
                                {DepthKind::Reversed, "reversed"}};

[[noreturn]] void refuse(const std::string& path, DepthKind kind, const std::string& expected,
                         const std::string& got) {
  throwFileError("read depth", path, fmt::format("{} for depth of the kind {}", expected, toString(kind)),
                 got);
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vector3& a) { return std::sqrt(dot(a, a)); }

/// What a depth becomes, or kNoSurfaceDepth: not finite, in front of no camera, or as far as the sky.
float surfaceDepth(double view) {
  return view > 0.0 && view < double(kSkyDepth) ? float(view) : kNoSurfaceDepth;  // false for NaN
}

/// Distances along rays become view depth by the angle between ray and axis. The ray's direction d solves
/// rowX.d = ndc.x rowW.d, rowY.d = ndc.y rowW.d by Cramer's rule, with rowW.d = 1.
void fromRays(Image& depth, const Matrix4& m, const std::array<double, 2>& jitterPx,
              const std::string& path) {
  const Vector3 rowX = {m[0], m[1], m[2]}, rowY = {m[4], m[5], m[6]}, rowW = {m[12], m[13], m[14]};
  const Vector3 byX = cross(rowY, rowW), byY = cross(rowW, rowX), byW = cross(rowX, rowY);
  const double determinant = std::abs(dot(rowX, byX));
  if (!(determinant > 0.0))
    refuse(path, DepthKind::Ray, "a perspective camera", "an orthographic or singular matrix");
  const double unit = determinant / length(rowW);  // view depth of a direction times its length
  for (int y = 0; y < depth.height; ++y) {
    for (int x = 0; x < depth.width; ++x) {
      const double ndcX = 2.0 * (x + 0.5 + jitterPx[0]) / depth.width - 1.0;
      const double ndcY = 1.0 - 2.0 * (y + 0.5 + jitterPx[1]) / depth.height;
      Vector3 ray;
      for (std::size_t axis = 0; axis < 3; ++axis)
        ray[axis] = ndcX * byX[axis] + ndcY * byY[axis] + byW[axis];
      float& value = depth.at(x, y, 0);
      value = surfaceDepth(double(value) * unit / length(ray));
    }
  }
}

/// `value`: 1 at the near plane, 0 at the far one. 1 / depth is linear in it.
float fromReversed(double value, const DepthRange& range) {
  if (!(value > 0.0 && value <= 1.0)) return kNoSurfaceDepth;
  const double atFar = range.far ? 1.0 / *range.far : 0.0;
  return surfaceDepth(1.0 / (atFar + value * (1.0 / range.near - atFar)));
}

}  // namespace

const char* toString(DepthKind kind) {
  return std::find_if(std::begin(kKinds), std::end(kKinds),
                      [kind](const NamedKind& k) { return k.kind == kind; })
      ->name;
}

std::vector<std::string> depthKindNames() {
  std::vector<std::string> names;
  for (const NamedKind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

DepthKind parseDepthKind(const std::string& text) {
  for (const NamedKind& kind : kKinds)
    if (text == kind.name) return kind.kind;
  throw Error(ErrorCode::InvalidArgument,
              {"depth", "kind", fmt::format("{}", fmt::join(depthKindNames(), ", ")), text});
}

Image viewDepthOf(Image depth, DepthKind kind, const DepthCamera& camera, const std::string& path) {
  if (kind == DepthKind::View) return depth;
  if (kind == DepthKind::Ray) {
    if (!camera.worldToClip) refuse(path, kind, "a camera", "none");
    fromRays(depth, *camera.worldToClip, camera.jitterPx, path);
    return depth;
  }
  if (!camera.range) refuse(path, kind, "\"near\" and \"far\" in camera.json", "none");
  if (kind == DepthKind::Hyperbolic && !camera.range->far)
    refuse(path, kind, "\"far\" in camera.json", "\"near\" alone");
  for (float& value : depth.pixels)
    value = fromReversed(kind == DepthKind::Hyperbolic ? 1.0 - double(value) : double(value), *camera.range);
  return depth;
}

}  // namespace quell::io

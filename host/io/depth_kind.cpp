#include "host/io/depth_kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <quell/error.hpp>

#include "host/core/depth.hpp"
#include "host/core/view_rays.hpp"
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
                                {DepthKind::NegativeView, "negative-view"},
                                {DepthKind::Ray, "ray"},
                                {DepthKind::Hyperbolic, "hyperbolic"},
                                {DepthKind::Reversed, "reversed"}};

[[noreturn]] void refuse(const std::string& path, DepthKind kind, const std::string& expected,
                         const std::string& got) {
  throwFileError("read depth", path, fmt::format("{} for depth of the kind {}", expected, toString(kind)),
                 got);
}

/// What a depth becomes, or kNoSurfaceDepth: not finite, in front of no camera, or as far as the sky.
float surfaceDepth(double view) {
  return view > 0.0 && view < double(kSkyDepth) ? float(view) : kNoSurfaceDepth;  // false for NaN
}

ViewRays raysOf(const Matrix4& worldToClip, const std::array<double, 2>& jitterPx, Size size,
                const std::string& path) {
  try {
    if (!isOrthographic(worldToClip)) return viewRays(worldToClip, jitterPx, size);
  } catch (const Error&) {  // singular
  }
  refuse(path, DepthKind::Ray, "a perspective camera", "an orthographic or singular matrix");
}

/// Distances along rays become view depth by the angle between ray and axis.
void fromRays(Image& depth, const Matrix4& worldToClip, const std::array<double, 2>& jitterPx,
              const std::string& path) {
  const ViewRays rays = raysOf(worldToClip, jitterPx, {depth.width, depth.height}, path);
  for (int y = 0; y < depth.height; ++y) {
    for (int x = 0; x < depth.width; ++x) {
      const Vector3 ray = rays.at(x, y);
      float& value = depth.at(x, y, 0);
      value = surfaceDepth(double(value) / std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]));
    }
  }
}

/// What is at the far plane or beyond it shows no surface.
void fromDepthBuffer(Image& depth, DepthKind kind, const DepthRange& range) {
  const double far = range.far.value_or(std::numeric_limits<double>::infinity());
  const ReciprocalDepth reciprocal = reciprocalDepth(kind, range.near, far);
  const double farthest = kind == DepthKind::Reversed ? 0.0 : 1.0;
  for (float& value : depth.pixels) {
    const bool inFront = value >= 0.0f && value <= 1.0f && double(value) != farthest;
    value = inFront ? surfaceDepth(1.0 / (reciprocal.constant + reciprocal.slope * double(value)))
                    : kNoSurfaceDepth;
  }
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
  if (kind == DepthKind::NegativeView) {
    for (float& value : depth.pixels) value = surfaceDepth(-double(value));
    return depth;
  }
  if (kind == DepthKind::Ray) {
    if (!camera.worldToClip) refuse(path, kind, "a camera", "none");
    fromRays(depth, *camera.worldToClip, camera.jitterPx, path);
    return depth;
  }
  if (!camera.range) refuse(path, kind, "\"near\" and \"far\" in camera.json", "none");
  if (kind == DepthKind::Hyperbolic && !camera.range->far)
    refuse(path, kind, "\"far\" in camera.json", "\"near\" alone");
  fromDepthBuffer(depth, kind, *camera.range);
  return depth;
}

}  // namespace quell::io

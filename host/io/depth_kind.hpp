// What the numbers of a depth image mean, and view depth from them.
#pragma once

#include <array>
#include <optional>
#include <quell/frame.hpp>
#include <string>
#include <vector>

#include "host/io/image.hpp"

namespace quell::io {

using quell::DepthKind;

/// "view", "negative-view", "ray", "hyperbolic" or "reversed", as in --channels depth=NAME:ray.
const char* toString(DepthKind kind);
/// The names of all kinds.
std::vector<std::string> depthKindNames();
/// Throws Error(InvalidArgument) that lists the kinds.
DepthKind parseDepthKind(const std::string& text);

/// The planes between which a depth buffer is spread out: entries "near" and "far" of camera.json.
struct DepthRange {
  double near = 0.0;          ///< scene units, > 0
  std::optional<double> far;  ///< scene units, > near; nothing: infinitely far, of DepthKind::Reversed alone
};

/// What a conversion needs besides the depth.
struct DepthCamera {
  std::optional<Matrix4> worldToClip;  ///< perspective, of DepthKind::Ray
  std::array<double, 2> jitterPx{};    ///< as Camera has it, of DepthKind::Ray
  std::optional<DepthRange> range;     ///< of the depth buffers
};

/// View depth of a pixel that shows no surface (Cycles writes it).
constexpr float kNoSurfaceDepth = 1e10f;

/// View depth (1 channel) of a depth image (1 channel). Pixels at or beyond the far plane or kSkyDepth, and values that
/// are not finite or not positive along a ray, become kNoSurfaceDepth. Throws Error(FileError) naming `path` where the
/// camera lacks what the kind needs: a perspective matrix, or near and far.
Image viewDepthOf(Image depth, DepthKind kind, const DepthCamera& camera, const std::string& path);

}  // namespace quell::io

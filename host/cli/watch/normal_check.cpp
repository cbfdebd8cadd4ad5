#include "host/cli/watch/normal_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "host/cli/watch/pixels.hpp"

namespace quell::cli {
namespace {

/// Of a unit length: half floats, averages over a pixel's edges.
constexpr double kUnitTolerance = 0.05;
/// A component below this is negative, one within this of 0.5 may be background that was packed.
constexpr double kZeroTolerance = 0.01;
/// Of the pixels: fewer without a normal are broken pixels rather than a habit of the renderer.
constexpr double kMissingShare = 0.001;
/// Of the normals: packed ones are of unit length once unpacked, and mostly are not before.
constexpr double kUnpackedShare = 0.9, kUnitShare = 0.5;
/// Light beyond emission, as a share of it: more than rounding to 8 bits.
constexpr double kLitShare = 0.02;

bool isUnit(const glm::dvec3& v) { return std::abs(glm::length(v) - 1.0) <= kUnitTolerance; }

/// A position, light other than its own, and, where there is an albedo, some of it: neither sky nor an emitter.
bool isLitSurface(const io::FrameData& frame, int x, int y) {
  const glm::dvec3 position = vectorAt(frame.positionWorld, x, y);
  if (!isFinite(position) || position == glm::dvec3(0.0)) return false;
  if (!frame.albedo.empty() && vectorAt(frame.albedo, x, y) == glm::dvec3(0.0)) return false;
  const double light = luminance(vectorAt(frame.radiance, x, y));
  const double emitted = frame.emission.empty() ? 0.0 : luminance(vectorAt(frame.emission, x, y));
  return light - emitted > kLitShare * light;
}

struct Counts {
  double pixels = 0.0, missing = 0.0, given = 0.0, negative = 0.0, unit = 0.0, unpackedUnit = 0.0;
};

Counts count(const io::FrameData& frame) {
  Counts counts;
  for (int y = 0; y < frame.normalWorld.height; ++y) {
    for (int x = 0; x < frame.normalWorld.width; ++x) {
      const glm::dvec3 normal = vectorAt(frame.normalWorld, x, y);
      const glm::dvec3 unpacked = 2.0 * normal - 1.0;
      counts.pixels += 1.0;
      if (normal == glm::dvec3(0.0)) counts.missing += isLitSurface(frame, x, y);
      if (normal == glm::dvec3(0.0) || !isFinite(normal) || glm::length(unpacked) < kZeroTolerance) continue;
      counts.given += 1.0;
      counts.negative += std::min({normal.x, normal.y, normal.z}) < -kZeroTolerance;
      counts.unit += isUnit(normal);
      counts.unpackedUnit += isUnit(unpacked);
    }
  }
  return counts;
}

}  // namespace

std::optional<io::FrameWarning> checkNormals(const io::FrameData& frame, const std::string& file) {
  using Kind = io::FrameWarning::Kind;
  const Counts counts = count(frame);
  if (counts.negative <= kMissingShare * counts.given && counts.unit < kUnitShare * counts.given &&
      counts.unpackedUnit > kUnpackedShare * counts.given)
    return io::FrameWarning{Kind::PackedNormals, file, "normals of unit length in world space",
                            "components from 0 to 1, of unit length only as 2 n - 1",
                            "goes on with wrong directions; write 2 n - 1"};
  if (counts.missing > kMissingShare * counts.pixels)
    return io::FrameWarning{
        Kind::MissingNormals, file, "a normal wherever light falls on a surface",
        fmt::format("length 0 on {:.1f} % of the pixels though they have light and a position",
                    100.0 * counts.missing / counts.pixels),
        "these count as background and stay noisy; write the normal of every surface"};
  return std::nullopt;
}

}  // namespace quell::cli

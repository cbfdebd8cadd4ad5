// Normals that a renderer wrote in another way than the contract says.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/check/checks.hpp"
#include "host/check/geometric_normals.hpp"

namespace quell::check {
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
/// Another reading must leave this share of the angle, from so many degrees on.
constexpr double kMuchBetter = 0.35, kSuspectDegrees = 4.0;
/// Shading normals stray from surfaces by bumps and by interpolation, but not by so much for most of a picture, degrees.
constexpr double kUnrelatedDegrees = 60.0;

bool isUnit(const glm::dvec3& v) { return std::abs(glm::length(v) - 1.0) <= kUnitTolerance; }

/// A position, light other than its own, and, where there is an albedo, some of it: neither sky nor an emitter.
bool isLitSurface(const Context& context, int x, int y) {
  const Frame& frame = context.now;
  if (!isFinite(context.positionAt(x, y))) return false;
  if (frame.albedo.present() && isZero(vectorAt(frame.albedo, x, y))) return false;
  const double light = luminanceAt(frame.radiance, x, y);
  return light - luminanceAt(frame.emission, x, y) > kLitShare * light;
}

void packed(const Context& context, Result& result) {
  double given = 0.0, negative = 0.0, unit = 0.0, unpackedUnit = 0.0;
  context.forEach([&](int x, int y) {
    const glm::dvec3 normal = vectorAt(context.now.normalWorld, x, y);
    const glm::dvec3 unpacked = 2.0 * normal - 1.0;
    if (isZero(normal) || !isFinite(normal) || glm::length(unpacked) < kZeroTolerance) return;
    given += 1.0;
    negative += std::min({normal.x, normal.y, normal.z}) < -kZeroTolerance;
    unit += isUnit(normal);
    unpackedUnit += isUnit(unpacked);
  });
  if (!(negative <= kMissingShare * given && unit < kUnitShare * given &&
        unpackedUnit > kUnpackedShare * given))
    return;
  result.normalsFit = false;
  result.add({"normals-packed", Severity::Wrong, "normalWorld", "normals of unit length in world space",
              "components from 0 to 1, of unit length only as 2 n - 1",
              "goes on with wrong directions; write 2 n - 1", std::size_t(given) * context.pixelsEach()});
}

void missing(const Context& context, Result& result) {
  std::size_t pixels = 0, count = 0;
  const auto mark = [&](int x, int y) {
    return isZero(vectorAt(context.now.normalWorld, x, y)) && isLitSurface(context, x, y) ? 1.0 : 0.0;
  };
  context.forEach([&](int x, int y) {
    ++pixels;
    count += mark(x, y) > 0.0;
  });
  const double share = double(count) / double(pixels);
  if (!(share > kMissingShare)) return;
  result.add(
      {"normals-missing", Severity::Doubtful, "normalWorld", "a normal wherever light falls on a surface",
       "length 0 on " + percent(share) + " of the pixels though they have light and a position",
       "these count as background and stay noisy; write the normal of every surface",
       count * context.pixelsEach()},
      context.mapOf(mark));
}

void lengths(const Context& context, Result& result) {
  if (context.surfaces().size() < kLeastSurfaces) return;
  std::vector<double> all;
  for (const Surface& surface : context.surfaces()) all.push_back(glm::length(surface.normal));
  const double length = median(std::move(all));
  result.figures.push_back({"length of normals, median", length, ""});
  if (!result.normalsFit || std::abs(length - 1.0) <= kUnitTolerance) return;
  const bool sum = length > 1.5 && std::abs(length - std::round(length)) < kUnitTolerance;
  result.add(
      {"normal-length", Severity::Note, "normalWorld", "any length, 1 is usual",
       fixed(length, 2) + " (median)",
       std::string("nothing to do for the filter, which normalises") +
           (sum ? "; a sum over " + fixed(length, 0) + " samples? Then look at the other images, too" : ""),
       0});
}

using Read = glm::dvec3 (*)(const glm::dvec3& given, const View& view);

struct Reading {
  const char* kind;
  const char* is;
  const char* cure;
  Read world;
};

glm::dvec3 fromView(const glm::dvec3& n, const View& view, double forward) {
  return n.x * view.right + n.y * view.up + n.z * forward * view.forward;
}

constexpr char kWorld[] = "rotate them to world space: multiply by the inverse of the view matrix's rotation";
constexpr char kAxes[] = "give normals and positions in one world; one exporter has turned its axes";

const std::vector<Reading>& readings() {
  static const std::vector<Reading> all = {
      {"normals-view-space", "as normals in view space (z backward)", kWorld,
       [](const glm::dvec3& n, const View& view) { return fromView(n, view, -1.0); }},
      {"normals-view-space", "as normals in view space (z forward)", kWorld,
       [](const glm::dvec3& n, const View& view) { return fromView(n, view, 1.0); }},
      {"normals-view-space", "as normals in view space (y down, z forward)", kWorld,
       [](const glm::dvec3& n, const View& view) {
         return fromView({n.x, -n.y, n.z}, view, 1.0);
       }},
      {"normals-axes", "with z negated", kAxes,
       [](const glm::dvec3& n, const View&) { return glm::dvec3(n.x, n.y, -n.z); }},
      {"normals-axes", "with y negated", kAxes,
       [](const glm::dvec3& n, const View&) { return glm::dvec3(n.x, -n.y, n.z); }},
      {"normals-axes", "with x negated", kAxes,
       [](const glm::dvec3& n, const View&) { return glm::dvec3(-n.x, n.y, n.z); }},
      {"normals-axes", "as normals whose y is up", kAxes,
       [](const glm::dvec3& n, const View&) { return glm::dvec3(n.x, -n.z, n.y); }},
      {"normals-axes", "as normals whose z is up", kAxes,
       [](const glm::dvec3& n, const View&) { return glm::dvec3(n.x, n.z, -n.y); }},
  };
  return all;
}

struct Pairing {
  const Surface* surface;
  glm::dvec3 geometric;
};

std::vector<double> angles(const std::vector<Pairing>& pairs, const View& view, Read read) {
  std::vector<double> all;
  all.reserve(pairs.size());
  for (const Pairing& pair : pairs)
    all.push_back(degreesBetweenLines(read(pair.surface->normal, view), pair.geometric));
  return all;
}

void flipped(const Context& context, Result& result) {
  std::size_t away = 0;
  for (const Surface& surface : context.surfaces())
    away += glm::dot(surface.normal, context.view->towards(surface.position)) < 0.0;
  const double share = double(away) / double(context.surfaces().size());
  result.figures.push_back({"normals that face away from the camera", 100.0 * share, "%"});
  if (!context.view->perspective || share <= 0.5) return;
  result.add({"normals-flipped", Severity::Doubtful, "normalWorld", "normals that face the camera",
              percent(share) + " of them face away",
              "negate those whose product with the direction to the camera is below 0",
              away * context.pixelsEach()});
}

void space(const Context& context, Result& result) {
  if (!result.geometryFits || !result.normalsFit || !context.view) return;
  std::vector<Pairing> pairs;
  for (const Surface& surface : context.surfaces())
    if (const auto normal = geometricNormal(context.size, surface.x, surface.y,
                                            [&](int x, int y) { return context.positionAt(x, y); }))
      pairs.push_back({&surface, *normal});
  if (pairs.size() < kLeastSurfaces) return;
  const double given =
      median(angles(pairs, *context.view, [](const glm::dvec3& n, const View&) { return n; }));
  result.figures.push_back({"angle between normals and surfaces, median", given, "degrees"});
  const Reading* best = nullptr;
  double least = kMuchBetter * given;
  for (const Reading& reading : readings()) {
    const double angle = median(angles(pairs, *context.view, reading.world));
    if (!(angle < least)) continue;
    best = &reading;
    least = angle;
  }
  const std::string off = fixed(given, 1) + " degrees off the surfaces (median)";
  constexpr char kExpected[] = "normals in world space, square to the surfaces of the positions";
  const std::size_t count = context.surfaces().size() * context.pixelsEach();
  if (given > kSuspectDegrees && best != nullptr) {
    result.normalsFit = false;
    result.add({best->kind, Severity::Wrong, "normalWorld", kExpected,
                off + "; " + fixed(least, 1) + " " + best->is, best->cure, count});
  } else if (given > kUnrelatedDegrees) {
    result.normalsFit = false;
    result.add({"normals-unrelated", Severity::Doubtful, "normalWorld", kExpected, off,
                "look whether they are those of the same frame and space as the positions", count});
  } else {
    flipped(context, result);
  }
}

}  // namespace

const Group& normalChecks() {
  static const Group group = {packed, missing, lengths, space};
  return group;
}

}  // namespace quell::check

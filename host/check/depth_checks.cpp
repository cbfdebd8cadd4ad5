// What view depth is, told by the surfaces that it makes: they must be square to the normals.
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host/check/checks.hpp"
#include "host/check/geometric_normals.hpp"

namespace quell::check {
namespace {

/// A reading must leave this share of the angle, from so many degrees on.
constexpr double kMuchBetter = 0.35, kSuspectDegrees = 3.0;
constexpr double kNegativeShare = 0.5;

struct Reading {
  const char* kind;
  const char* is;
  const char* cure;
  /// View depth from what is given; `ray` is the direction at view depth 1.
  double (*depth)(double given, const glm::dvec3& ray);
  Matrix4 (*camera)(const Matrix4& given);
};

Matrix4 asGiven(const Matrix4& m) { return m; }
double viewZ(double given, const glm::dvec3&) { return given; }

const std::vector<Reading>& readings() {
  static const std::vector<Reading> all = {
      {"depth-ray", "as distances along rays",
       "divide by the length of the ray at view depth 1, or give positions",
       [](double given, const glm::dvec3& ray) { return given / glm::length(ray); }, asGiven},
      {"depth-hyperbolic", "as a z-buffer's values",
       "make them linear: near * far / (far - z * (far - near)), or give positions",
       [](double given, const glm::dvec3&) { return 1.0 / (1.0 - given); }, asGiven},
      {"depth-reversed", "as a reversed z-buffer's values",
       "make them linear: near / z with far at infinity, or give positions",
       [](double given, const glm::dvec3&) { return 1.0 / given; }, asGiven},
      {"camera-transposed", "with the matrices transposed",
       "transpose all matrices: row-major, for column vectors (GLM and OpenGL keep columns)", viewZ,
       transposed},
      {"image-flipped-y", "with y of the image turned over",
       "turn the rows of all images over, or negate row 1 of both matrices", viewZ,
       [](const Matrix4& m) {
         return scaledRows(m, {1, -1, 1, 1});
       }},
  };
  return all;
}

/// Median angle between normals and the surfaces of a reading, degrees.
double angleOf(const Context& context, double (*depth)(double, const glm::dvec3&),
               const Matrix4& worldToClip) {
  const auto view = viewOf(worldToClip);
  if (!view || !view->perspective) return std::numeric_limits<double>::infinity();
  const Frame& frame = context.now;
  const auto positionAt = [&](int x, int y) {
    const glm::dvec2 pixel(x + 0.5 + frame.camera.jitterPx[0], y + 0.5 + frame.camera.jitterPx[1]);
    const glm::dvec3 ray = rayThrough(worldToClip, *view, pixel, context.size);
    return view->eye + depth(double(frame.viewDepth.at(x, y, 0)), ray) * ray;
  };
  std::vector<double> angles;
  for (const Surface& surface : context.surfaces())
    if (const auto normal = geometricNormal(context.size, surface.x, surface.y, positionAt))
      angles.push_back(degreesBetweenLines(*normal, surface.normal));
  return angles.size() < kLeastSurfaces ? std::numeric_limits<double>::infinity() : median(std::move(angles));
}

bool isNegative(const Context& context, Result& result) {
  std::size_t negative = 0, given = 0;
  context.forEach([&](int x, int y) {
    const float depth = context.now.viewDepth.at(x, y, 0);
    given += std::abs(depth) > 0.0f;
    negative += depth < 0.0f;
  });
  if (!(double(negative) > kNegativeShare * double(given))) return false;
  result.geometryFits = false;
  result.add({"depth-negative", Severity::Wrong, "viewDepth", "depth that is positive in front of the camera",
              "below 0 on " + percent(double(negative) / double(given)) + " of the pixels",
              "negate it: it is z of view space", negative * context.pixelsEach()});
  return true;
}

void depthKind(const Context& context, Result& result) {
  const Frame& frame = context.now;
  if (!result.geometryFits) return;
  if (frame.positionWorld.present() || !frame.viewDepth.present() || isNegative(context, result)) return;
  const double given = angleOf(context, viewZ, frame.camera.worldToClip);
  if (!std::isfinite(given)) return;
  result.figures.push_back(
      {"angle between normals and the surfaces that depth makes, median", given, "degrees"});
  if (given < kSuspectDegrees) return;
  const Reading* best = nullptr;
  double least = kMuchBetter * given;
  for (const Reading& reading : readings()) {
    const double angle = angleOf(context, reading.depth, reading.camera(frame.camera.worldToClip));
    if (!(angle < least)) continue;
    best = &reading;
    least = angle;
  }
  if (best == nullptr) return;
  result.geometryFits = false;
  result.add({best->kind, Severity::Wrong, best->depth == viewZ ? "camera" : "viewDepth",
              "depth along the view axis, so that surfaces are square to their normals",
              fixed(given, 1) + " degrees off (median); " + fixed(least, 1) + " " + best->is, best->cure,
              context.surfaces().size() * context.pixelsEach()});
}

}  // namespace

const Group& depthChecks() {
  static const Group group = {depthKind};
  return group;
}

}  // namespace quell::check

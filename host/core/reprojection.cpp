#include "host/core/reprojection.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <quell/error.hpp>
#include <string>

namespace quell {
namespace {

// A 3x3 determinant below this share of the product of its row lengths means that the rows are linearly
// dependent.
constexpr double kSingular = 1e-12;

// Row 3 by the longer of rows 0 and 1 is about the tangent of half the field of view. Below this, a fifth of a second of
// arc, it is what rounding has left of an orthographic camera.
constexpr double kParallel = 1e-6;

// Rows of a row-major matrix as vectors, since GLM stores columns.
glm::dvec3 rowLinear(const Matrix4& m, int row) { return {m[4 * row], m[4 * row + 1], m[4 * row + 2]}; }
double rowConstant(const Matrix4& m, int row) { return m[4 * row + 3]; }

[[noreturn]] void refuse(const char* name, const std::string& expected, const std::string& got) {
  throw Error(ErrorCode::InvalidArgument, {"camera", name, expected, got});
}

void checkFinite(const Matrix4& m, const char* name) {
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (!std::isfinite(m[i])) {
      refuse(
          name, "finite elements",
          "element [" + std::to_string(i / 4) + "][" + std::to_string(i % 4) + "] = " + std::to_string(m[i]));
    }
  }
}

// Solves dot(a, p) = x, dot(b, p) = y, dot(c, p) = z by Cramer's rule.
glm::dvec3 solve(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 right, const char* name) {
  const double determinant = glm::dot(a, glm::cross(b, c));
  if (!(std::abs(determinant) > kSingular * glm::length(a) * glm::length(b) * glm::length(c)))
    refuse(name, "a matrix whose view axes are independent", "a singular matrix");
  return (right.x * glm::cross(b, c) + right.y * glm::cross(c, a) + right.z * glm::cross(a, b)) / determinant;
}

glm::dvec3 position(const Matrix4& m, const char* name) {
  checkFinite(m, name);
  if (isOrthographic(m)) {
    if (!(rowConstant(m, 3) > 0.0)) refuse(name, "clip.w > 0", std::to_string(rowConstant(m, 3)));
    // Any point on the view axis will do; the one nearest the world origin exists for every such matrix.
    const glm::dvec3 axis = glm::cross(rowLinear(m, 0), rowLinear(m, 1));
    return solve(rowLinear(m, 0), rowLinear(m, 1), axis, {-rowConstant(m, 0), -rowConstant(m, 1), 0.0}, name);
  }
  return solve(rowLinear(m, 0), rowLinear(m, 1), rowLinear(m, 3),
               {-rowConstant(m, 0), -rowConstant(m, 1), -rowConstant(m, 3)}, name);
}

QuellFloat4 toFloat4(glm::dvec3 v, double w) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

glm::dvec3 toVector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
std::array<double, 3> toArray(glm::dvec3 v) { return {v.x, v.y, v.z}; }

// The float nearest to v. Volatile: GCC 12 vectorises (double)(float)v at -O2 and drops the rounding, which
// left nothing for the low part of the camera position.
double roundedToFloat(double v) {
  const volatile float rounded = static_cast<float>(v);
  return rounded;
}

// One row of a matrix, applied to positions relative to `origin`.
struct Row {
  glm::dvec3 linear;
  double constant;
};

Row rowRelativeTo(const Matrix4& m, int row, glm::dvec3 origin) {
  return {rowLinear(m, row), rowConstant(m, row) + glm::dot(rowLinear(m, row), origin)};
}

QuellFloat4 combine(const Row& a, double scaleA, const Row& b, double scaleB) {
  return toFloat4(scaleA * a.linear + scaleB * b.linear, scaleA * a.constant + scaleB * b.constant);
}

// Rows that give pixel indices, the viewport folded in, and clip.w.
struct PixelRows {
  QuellFloat4 x, y, w;
};

PixelRows pixelRows(const Matrix4& worldToClip, Size size, glm::dvec3 origin) {
  const Row x = rowRelativeTo(worldToClip, 0, origin);
  const Row y = rowRelativeTo(worldToClip, 1, origin);
  const Row w = rowRelativeTo(worldToClip, 3, origin);
  return {combine(x, 0.5 * size.width, w, 0.5 * size.width - 0.5),
          combine(y, -0.5 * size.height, w, 0.5 * size.height - 0.5), toFloat4(w.linear, w.constant)};
}

// Zero for orthographic cameras, whose background has no direction to tell apart.
void setViewRays(ReprojectionParams& params, const Camera& camera, Size size) {
  if (isOrthographic(camera.worldToClip)) return;
  const ViewRays rays = viewRays(camera.worldToClip, camera.jitterPx, size);
  params.rayOrigin = toFloat4(toVector(rays.origin), 0.0);
  params.rayX = toFloat4(toVector(rays.stepX), 0.0);
  params.rayY = toFloat4(toVector(rays.stepY), 0.0);
}

void checkJitter(const Camera& camera) {
  for (const double component : camera.jitterPx)
    if (!(std::abs(component) <= kMaxJitterPx))
      refuse("jitterPx", "pixels in [-1, 1]", std::to_string(component));
}

}  // namespace

bool isOrthographic(const Matrix4& worldToClip) {
  const double across =
      std::max(glm::length(rowLinear(worldToClip, 0)), glm::length(rowLinear(worldToClip, 1)));
  return glm::length(rowLinear(worldToClip, 3)) <= kParallel * across;
}

std::array<double, 3> cameraPositionWorld(const Matrix4& worldToClip, const char* name) {
  const glm::dvec3 p = position(worldToClip, name);
  return {p.x, p.y, p.z};
}

std::array<double, 3> ViewRays::at(int x, int y) const {
  return toArray(toVector(origin) + double(x) * toVector(stepX) + double(y) * toVector(stepY));
}

ViewRays viewRays(const Matrix4& worldToClip, const std::array<double, 2>& jitterPx, Size size) {
  const glm::dvec3 x = rowLinear(worldToClip, 0);
  const glm::dvec3 y = rowLinear(worldToClip, 1);
  const glm::dvec3 w = rowLinear(worldToClip, 3);
  const double depthUnit = glm::length(w);  // clip.w at view depth 1
  const auto ray = [&](double ndcX, double ndcY) {
    return depthUnit * solve(x, y, w, {ndcX, ndcY, 1.0}, "worldToClip");
  };
  const double firstX = (1.0 + 2.0 * jitterPx[0]) / size.width - 1.0;
  const double firstY = 1.0 - (1.0 + 2.0 * jitterPx[1]) / size.height;
  const glm::dvec3 first = ray(firstX, firstY);
  return {toArray(first), toArray(ray(firstX + 2.0 / size.width, firstY) - first),
          toArray(ray(firstX, firstY - 2.0 / size.height) - first)};
}

ReprojectionParams makeReprojectionParams(const Camera& camera, Size size, const DiscardLimits& limits,
                                          bool historyValid, const std::array<double, 2>& motionScale) {
  checkJitter(camera);
  const glm::dvec3 origin = position(camera.worldToClip, "worldToClip");
  ReprojectionParams params{};
  params.historyValid = historyValid ? 1 : 0;
  params.motionScaleX = static_cast<float>(motionScale[0]);
  params.motionScaleY = static_cast<float>(motionScale[1]);

  const glm::dvec3 high(roundedToFloat(origin.x), roundedToFloat(origin.y), roundedToFloat(origin.z));
  params.cameraHigh = toFloat4(high, 0.0);
  params.cameraLow = toFloat4(origin - high, 0.0);
  const PixelRows rows = pixelRows(camera.worldToClip, size, origin);
  params.pixelX = rows.x;
  params.pixelY = rows.y;
  params.clipW = rows.w;
  const Row axis = rowRelativeTo(camera.worldToClip, isOrthographic(camera.worldToClip) ? 2 : 3, origin);
  params.viewDepth = toFloat4(axis.linear / glm::length(axis.linear), 0.0);
  setViewRays(params, camera, size);

  if (historyValid) {
    const glm::dvec3 originPrev = position(camera.worldToClipPrev, "worldToClipPrev");
    params.cameraMotion = toFloat4(originPrev - origin, 0.0);
    const PixelRows rowsPrev = pixelRows(camera.worldToClipPrev, size, origin);
    params.pixelXPrev = rowsPrev.x;
    params.pixelYPrev = rowsPrev.y;
    params.clipWPrev = rowsPrev.w;
  }

  // A pixel covers 2 / size of normalised device coordinates, so at clip.w = 1 this many scene units.
  const double footprint = std::max(2.0 / (size.width * glm::length(rowLinear(camera.worldToClip, 0))),
                                    2.0 / (size.height * glm::length(rowLinear(camera.worldToClip, 1))));
  params.footprint = static_cast<float>(footprint);
  params.positionLimit = static_cast<float>(limits.position);
  params.positionLimitFootprint = static_cast<float>(limits.positionFootprints * footprint);
  params.normalLimitSquared = static_cast<float>(limits.normalSquared);
  return params;
}

}  // namespace quell

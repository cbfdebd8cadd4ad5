#include "host/check/view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "host/core/reprojection.hpp"

namespace quell::check {
namespace {

// A determinant below this share of the product of lengths: linearly dependent.
constexpr double kSingular = 1e-12;

bool allFinite(const Matrix4& m) {
  return std::all_of(m.begin(), m.end(), [](double v) { return std::isfinite(v); });
}

/// Solves dot(a, p) = x, dot(b, p) = y, dot(c, p) = z; the rows are independent.
glm::dvec3 solve(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& right) {
  return (right.x * glm::cross(b, c) + right.y * glm::cross(c, a) + right.z * glm::cross(a, b)) /
         glm::dot(a, glm::cross(b, c));
}

glm::dvec3 across(const glm::dvec3& row, const glm::dvec3& forward) {
  return glm::normalize(row - glm::dot(row, forward) * forward);
}

}  // namespace

glm::dvec3 rowOf(const Matrix4& matrix, int row) {
  const double* m = &matrix[4 * std::size_t(row)];
  return {m[0], m[1], m[2]};
}

double clipOf(const Matrix4& matrix, int row, const glm::dvec3& p) {
  return glm::dot(rowOf(matrix, row), p) + matrix[4 * std::size_t(row) + 3];
}

std::optional<glm::dvec2> project(const Matrix4& worldToClip, const glm::dvec3& p, Size size) {
  const double w = clipOf(worldToClip, 3, p);
  if (!(w > 0.0)) return std::nullopt;
  const glm::dvec2 place((0.5 + 0.5 * clipOf(worldToClip, 0, p) / w) * size.width,
                         (0.5 - 0.5 * clipOf(worldToClip, 1, p) / w) * size.height);
  if (!std::isfinite(place.x) || !std::isfinite(place.y)) return std::nullopt;
  return place;
}

glm::dvec3 View::towards(const glm::dvec3& p) const {
  return perspective ? glm::normalize(eye - p) : -forward;
}

std::optional<View> viewOf(const Matrix4& m) {
  if (!allFinite(m)) return std::nullopt;
  const glm::dvec3 x = rowOf(m, 0), y = rowOf(m, 1);
  View view;
  view.perspective = !isOrthographic(m);
  const glm::dvec3 w = view.perspective ? rowOf(m, 3) : glm::cross(y, x);
  if (!(std::abs(glm::dot(x, glm::cross(y, w))) >
        kSingular * glm::length(x) * glm::length(y) * glm::length(w)))
    return std::nullopt;
  view.depthUnit = glm::length(w);
  view.forward = w / view.depthUnit;
  view.right = across(x, view.forward);
  view.up = across(y, view.forward);
  if (view.perspective) view.eye = solve(x, y, w, {-m[3], -m[7], -m[15]});
  return view;
}

glm::dvec3 rayThrough(const Matrix4& m, const View& view, const glm::dvec2& pixel, Size size) {
  const glm::dvec3 ndc(2.0 * pixel.x / size.width - 1.0, 1.0 - 2.0 * pixel.y / size.height, 1.0);
  return view.depthUnit * solve(rowOf(m, 0), rowOf(m, 1), rowOf(m, 3), ndc);
}

Matrix4 transposed(const Matrix4& m) {
  Matrix4 result{};
  for (std::size_t i = 0; i < 16; ++i) result[i] = m[4 * (i % 4) + i / 4];
  return result;
}

Matrix4 scaledRows(Matrix4 m, const std::array<double, 4>& factors) {
  for (std::size_t i = 0; i < 16; ++i) m[i] *= factors[i / 4];
  return m;
}

Matrix4 scaledColumns(Matrix4 m, const std::array<double, 4>& factors) {
  for (std::size_t i = 0; i < 16; ++i) m[i] *= factors[i % 4];
  return m;
}

std::optional<Matrix4> inverse(const Matrix4& m) {
  glm::dmat4 given;
  for (int i = 0; i < 16; ++i) given[i % 4][i / 4] = m[std::size_t(i)];
  const glm::dmat4 inverted = glm::inverse(given);
  Matrix4 result{};
  for (int i = 0; i < 16; ++i) result[std::size_t(i)] = inverted[i % 4][i / 4];
  if (!allFinite(result)) return std::nullopt;
  return result;
}

}  // namespace quell::check

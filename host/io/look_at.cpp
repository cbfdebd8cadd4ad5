#include "host/io/look_at.hpp"

#include <cmath>

namespace quell::io {
namespace {

using Vector3 = std::array<double, 3>;

/// Sine of the angle to the view axis below which `up` says nothing.
constexpr double kLeastSine = 1e-9;

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Nothing for a vector no longer than `least`.
std::optional<Vector3> unit(const Vector3& a, double least) {
  const double length = std::sqrt(dot(a, a));
  if (!(length > least)) return std::nullopt;
  return Vector3{a[0] / length, a[1] / length, a[2] / length};
}

}  // namespace

std::optional<Matrix4> lookAtMatrix(const LookAt& view, double aspect) {
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  const Vector3& eye = view.eye;
  const auto axis = unit({view.target[0] - eye[0], view.target[1] - eye[1], view.target[2] - eye[2]}, 0.0);
  const auto up = unit(view.up, 0.0);
  if (!axis || !up) return std::nullopt;
  const auto right = unit(cross(*axis, *up), kLeastSine);
  if (!right) return std::nullopt;
  const bool alongX = view.axis == FovAxis::X || (view.axis == FovAxis::Smaller && aspect < 1.0) ||
                      (view.axis == FovAxis::Larger && aspect >= 1.0);
  const double focal = 1.0 / std::tan(0.5 * kRadians * view.fovDegrees);
  const double scaleX = alongX ? focal : focal / aspect, scaleY = alongX ? focal * aspect : focal;
  const Vector3 top = cross(*right, *axis);
  Matrix4 matrix{};
  const auto setRow = [&](std::size_t row, const Vector3& direction, double scale) {
    for (std::size_t i = 0; i < 3; ++i) matrix[4 * row + i] = scale * direction[i];
    matrix[4 * row + 3] = -scale * dot(direction, eye);
  };
  setRow(0, *right, scaleX);
  setRow(1, top, scaleY);
  setRow(2, *axis, 1.0);
  setRow(3, *axis, 1.0);
  return matrix;
}

}  // namespace quell::io

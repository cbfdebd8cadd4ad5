#include <cmath>
#include <glm/glm.hpp>
#include <quell/camera.hpp>
#include <quell/error.hpp>
#include <string>

#include "host/core/pinhole.hpp"

namespace quell {
namespace {

/// Sine of the angle to the view axis below which `up` says nothing.
constexpr double kLeastSine = 1e-9;

glm::dvec3 toVector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// Nothing for a vector no longer than `least`.
std::optional<glm::dvec3> unit(glm::dvec3 v, double least) {
  const double length = glm::length(v);
  if (!(length > least && std::isfinite(length))) return std::nullopt;
  return v / length;
}

template <class Number>
Matrix4 inRows(const Number* numbers, MatrixOrder order) {
  if (numbers == nullptr)
    throw Error(ErrorCode::InvalidArgument, {"toMatrix4", "numbers", "16 numbers", "null"});
  Matrix4 matrix{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      matrix[4 * row + column] =
          static_cast<double>(numbers[order == MatrixOrder::Rows ? 4 * row + column : 4 * column + row]);
  return matrix;
}

void requirePositive(const char* name, double value, double below, const char* expected) {
  if (!(value > 0.0 && value < below))
    throw Error(ErrorCode::InvalidArgument, {"lookAt", name, expected, std::to_string(value)});
}

}  // namespace

double focalLength(double fovDegrees) {
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  return 1.0 / std::tan(0.5 * kRadians * fovDegrees);
}

std::optional<Matrix4> pinholeMatrix(const std::array<double, 3>& eye, const std::array<double, 3>& target,
                                     const std::array<double, 3>& up, const std::array<double, 2>& focal) {
  const auto axis = unit(toVector(target) - toVector(eye), 0.0);
  const auto upwards = unit(toVector(up), 0.0);
  if (!axis || !upwards) return std::nullopt;
  const auto right = unit(glm::cross(*axis, *upwards), kLeastSine);
  if (!right) return std::nullopt;
  Matrix4 matrix{};
  const auto setRow = [&](std::size_t row, const glm::dvec3& direction, double scale) {
    for (int i = 0; i < 3; ++i) matrix[4 * row + std::size_t(i)] = scale * direction[i];
    matrix[4 * row + 3] = -scale * glm::dot(direction, toVector(eye));
  };
  setRow(0, *right, focal[0]);
  setRow(1, glm::cross(*right, *axis), focal[1]);
  setRow(2, *axis, 1.0);
  setRow(3, *axis, 1.0);
  return matrix;
}

Matrix4 toMatrix4(const float* numbers, MatrixOrder order) { return inRows(numbers, order); }
Matrix4 toMatrix4(const double* numbers, MatrixOrder order) { return inRows(numbers, order); }

Matrix4 product(const Matrix4& viewToClip, const Matrix4& worldToView) {
  Matrix4 result{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      for (std::size_t i = 0; i < 4; ++i)
        result[4 * row + column] += viewToClip[4 * row + i] * worldToView[4 * i + column];
  return result;
}

Matrix4 lookAt(const std::array<double, 3>& eye, const std::array<double, 3>& target,
               const std::array<double, 3>& up, double verticalFovDegrees, double aspect) {
  requirePositive("verticalFovDegrees", verticalFovDegrees, 180.0, "degrees in (0, 180)");
  requirePositive("aspect", aspect, 1e6, "width by height, in (0, 1e6)");
  const double focal = focalLength(verticalFovDegrees);
  const auto matrix = pinholeMatrix(eye, target, up, {focal / aspect, focal});
  if (!matrix)
    throw Error(
        ErrorCode::InvalidArgument,
        {"lookAt", "target", "a point off the eye, and `up` off the line between them", "no picture"});
  return *matrix;
}

}  // namespace quell

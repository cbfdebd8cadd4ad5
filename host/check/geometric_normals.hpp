// The normal of a surface from the positions around a pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "host/check/context.hpp"

namespace quell::check {

/// Steps to the neighbours of a surface that goes on differ by at most this factor.
constexpr double kSteadySteps = 3.0;

/// Twice the step from one side of `middle` to the other; nothing across an edge.
inline std::optional<glm::dvec3> steadyStep(const glm::dvec3& before, const glm::dvec3& middle,
                                            const glm::dvec3& after) {
  const double one = glm::length(middle - before), other = glm::length(after - middle);
  if (!(one > 0.0 && other > 0.0 && std::max(one, other) <= kSteadySteps * std::min(one, other)))
    return std::nullopt;
  return after - before;
}

/// Of unit length, either way; nothing at edges and borders. `positionAt` gives NaN where there is no surface.
template <class PositionAt>
std::optional<glm::dvec3> geometricNormal(Size size, int x, int y, const PositionAt& positionAt) {
  if (x < 1 || y < 1 || x + 1 >= size.width || y + 1 >= size.height) return std::nullopt;
  const glm::dvec3 middle = positionAt(x, y);
  const auto across = steadyStep(positionAt(x - 1, y), middle, positionAt(x + 1, y));
  const auto down = steadyStep(positionAt(x, y - 1), middle, positionAt(x, y + 1));
  if (!across || !down) return std::nullopt;
  const glm::dvec3 normal = glm::cross(*across, *down);
  const double length = glm::length(normal);
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  return normal / length;
}

/// Between two directions of any length, 0 to 180.
inline double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::degrees(std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0)));
}

/// Whichever way they point, 0 to 90.
inline double degreesBetweenLines(const glm::dvec3& a, const glm::dvec3& b) {
  const double angle = degreesBetween(a, b);
  return std::min(angle, 180.0 - angle);
}

}  // namespace quell::check

// Pixels of images in host memory as vectors.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "host/io/image.hpp"
#include "host/metrics/display_encoding.hpp"

namespace quell::cli {

/// The first three channels of an image that has as many.
inline glm::dvec3 vectorAt(const io::Image& image, int x, int y) {
  return {double(image.at(x, y, 0)), double(image.at(x, y, 1)), double(image.at(x, y, 2))};
}

inline bool isFinite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Rec. 709.
inline double luminance(const glm::dvec3& rgb) { return metrics::luma(rgb.x, rgb.y, rgb.z); }

}  // namespace quell::cli

// Small scenes and statistics for the tests of the path tracer.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>
#include <string>

#include "host/core/program_cache.hpp"
#include "host/io/image.hpp"
#include "host/render/materials.hpp"
#include "host/render/path_tracer.hpp"
#include "host/render/scene.hpp"

namespace quell::tests {

inline glm::dvec3 pixel3(const io::Image& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

/// The device that QUELL_TEST_DEVICE names (index or part of a name), by default the preferred one.
inline std::string testDevice() {
  const char* spec = std::getenv("QUELL_TEST_DEVICE");
  return spec != nullptr ? spec : "";
}

inline render::PathTracer makeTracer(Size size) { return {testDevice(), defaultCacheDirectory(), size}; }

/// The same radiance from everywhere.
inline render::Sky uniformSky(double radiance) {
  render::Sky sky;
  sky.zenith = sky.horizon = sky.ground = glm::dvec3(radiance);
  return sky;
}

/// Mean and variance of values that come one by one.
struct Statistics {
  double count = 0.0, sum = 0.0, squares = 0.0;
  void add(double value) {
    count += 1.0;
    sum += value;
    squares += value * value;
  }
  double mean() const { return sum / count; }
  double variance() const { return std::max(0.0, (squares - sum * sum / count) / (count - 1.0)); }
  double standardErrorSquared() const { return variance() / count; }
};

/// How many standard errors lie between two means.
inline double standardErrors(const Statistics& a, const Statistics& b) {
  return std::abs(a.mean() - b.mean()) /
         std::sqrt(a.standardErrorSquared() + b.standardErrorSquared() + 1e-18);
}

}  // namespace quell::tests

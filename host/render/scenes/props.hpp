// What several scenes are furnished with.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <random>

#include "host/render/scene.hpp"

namespace quell::render {

/// Uniform numbers that are the same on every platform.
class SceneRandom {
 public:
  explicit SceneRandom(std::uint32_t seed) : m_engine(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (double(m_engine()) / 4294967296.0); }
  /// Uniform over the unit sphere.
  glm::dvec3 direction();

 private:
  std::mt19937 m_engine;
};

/// Materials of the six faces of a room; a negative index leaves a face open.
struct RoomMaterials {
  int floor = -1;
  int ceiling = -1;
  int left = -1;   ///< low x
  int right = -1;  ///< high x
  int back = -1;   ///< high y
  int front = -1;  ///< low y
};

/// Rectangles that face inwards.
void addRoom(Scene& scene, const glm::dvec3& low, const glm::dvec3& high, const RoomMaterials& materials);

/// A table with four legs; `center` is on the floor, `halfExtents` those of the top (x, y) and the height (z).
void addTable(Scene& scene, const glm::dvec3& center, const glm::dvec3& halfExtents, int material);

/// A row of `count` balusters with a rail from `from` to `to`, on the floor at their height z.
void addRailing(Scene& scene, const glm::dvec3& from, const glm::dvec3& to, double height, int count,
                int material);

}  // namespace quell::render

#include "host/render/scenes/props.hpp"

#include <cmath>

namespace quell::render {

glm::dvec3 SceneRandom::direction() {
  const double z = uniform(-1.0, 1.0);
  const double angle = uniform(0.0, 6.283185307179586);
  const double ring = std::sqrt(1.0 - z * z);
  return {ring * std::cos(angle), ring * std::sin(angle), z};
}

void addRoom(Scene& scene, const glm::dvec3& low, const glm::dvec3& high, const RoomMaterials& materials) {
  const glm::dvec3 center = 0.5 * (low + high);
  const glm::dvec3 half = 0.5 * (high - low);
  const int faces[6] = {materials.left, materials.right, materials.front,
                        materials.back, materials.floor, materials.ceiling};
  for (int face = 0; face < 6; ++face) {
    if (faces[face] < 0) continue;
    const int axis = face / 2;
    glm::dvec3 inwards(0.0);
    inwards[axis] = face % 2 == 0 ? 1.0 : -1.0;
    const glm::dmat3 rotation = facing(inwards);
    const double halfX = glm::dot(glm::abs(rotation[0]), half);
    const double halfY = glm::dot(glm::abs(rotation[1]), half);
    scene.rectangle({center - inwards * half[axis], rotation}, halfX, halfY, faces[face]);
  }
}

void addTable(Scene& scene, const glm::dvec3& center, const glm::dvec3& halfExtents, int material) {
  constexpr double kTopM = 0.03;  // half of its thickness
  constexpr double kLegM = 0.03;
  const double legHalf = 0.5 * (halfExtents.z - 2.0 * kTopM);
  const int id = scene.box({center + glm::dvec3(0.0, 0.0, halfExtents.z - kTopM)},
                           {halfExtents.x, halfExtents.y, kTopM}, material);
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      scene.cylinder({center + glm::dvec3(x * (halfExtents.x - 2.0 * kLegM),
                                          y * (halfExtents.y - 2.0 * kLegM), legHalf)},
                     kLegM, legHalf, material, id);
}

void addRailing(Scene& scene, const glm::dvec3& from, const glm::dvec3& to, double height, int count,
                int material) {
  constexpr double kBalusterM = 0.025;
  constexpr double kRailM = 0.045;
  const glm::dvec3 up(0.0, 0.0, height);
  const int id = scene.cylinder({0.5 * (from + to) + up, facing(to - from)}, kRailM,
                                0.5 * glm::length(to - from), material);
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 foot = glm::mix(from, to, (i + 0.5) / count);
    scene.cylinder({foot + 0.5 * up}, kBalusterM, 0.5 * height, material, id);
  }
}

}  // namespace quell::render

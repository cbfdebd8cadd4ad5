// Geometry of the built-in test scene: a seaside room of boxes, spheres and round columns, hit in closed
// form. Right-handed, z up, metres. The far side (+y) is open to the sky; all other sides are closed.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace quell::io::analytic {

/// What a primitive is made of; analytic_material.hpp says how each looks.
enum class Surface {
  WoodFloor,
  BeamWood,   // grain along x
  BenchWood,  // grain along y
  Bricks,
  StripedWall,
  Plaster,
  Sandstone,
  Rug,
  Marble,
  RedPaint,
  BluePaint,
  OchrePaint,
  Lamp,
};

/// A half line. `direction` has unit length.
struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;
};

/// Where a ray meets the scene. `normal` is geometric, unit length, and points to the side the ray came from.
struct Hit {
  double distance = 0.0;  ///< m, > 0
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};
  Surface surface = Surface::Plaster;
};

/// Corners of the lamp, a flat box that shines downwards from its lower face, in m.
constexpr glm::dvec3 kLampLow{-1.0, 0.1, 3.02};
constexpr glm::dvec3 kLampHigh{1.0, 1.1, 3.08};

/// The first surface along the ray, or nothing where the ray leaves for the sky.
std::optional<Hit> nearestHit(const Ray& ray);

/// True where something stands between the ray's origin and the point `maxDistance` (m) along it.
bool isOccluded(const Ray& ray, double maxDistance);

}  // namespace quell::io::analytic

// A scene at one moment: shapes with materials, lights, sky and camera. World space is right-handed, z up, metres;
// radiance is linear, Rec. 709 primaries.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "host/render/pinhole_camera.hpp"
#include "kernels/render/scene_params.h"

namespace quell::render {

/// Values of QUELL_PATTERN_*; scene_params.h says what each looks like.
enum class Pattern {
  Constant = QUELL_PATTERN_CONSTANT,
  Noise = QUELL_PATTERN_NOISE,
  Patches = QUELL_PATTERN_PATCHES,
  Checker = QUELL_PATTERN_CHECKER,
  Stripes = QUELL_PATTERN_STRIPES,
  Ramp = QUELL_PATTERN_RAMP,
  Bricks = QUELL_PATTERN_BRICKS,
  Tiles = QUELL_PATTERN_TILES,
  Marble = QUELL_PATTERN_MARBLE,
};

/// low where the pattern is 0, high where it is 1; `scale` in periods per metre. One number: constant.
struct Texture {
  Pattern pattern = Pattern::Constant;
  double scale = 1.0;
  double low = 0.0;
  double high = 0.0;

  Texture() = default;
  Texture(double value) : low(value), high(value) {}
  Texture(Pattern p, double s, double l = 0.0, double h = 1.0) : pattern(p), scale(s), low(l), high(h) {}
};

/// color = albedo * diffuse light + tint * GGX light (Fresnel included) + emission.
struct Material {
  glm::dvec3 albedoA{0.0};   ///< in [0, 1)
  glm::dvec3 albedoB{0.0};   ///< where `pattern` is 1
  glm::dvec3 f0{0.04};       ///< reflectance at normal incidence, in [0, 1]; 1: no Fresnel
  glm::dvec3 metalF0{0.04};  ///< the same where `metal` is 1
  glm::dvec3 tint{0.0};      ///< colour of the GGX lobe beside Fresnel, in [0, 1]; 0: no such lobe
  glm::dvec3 emission{0.0};  ///< radiance; any makes the shape a light
  Texture pattern;           ///< mixes the albedos
  Texture metal;             ///< 0: albedo and f0; 1: no albedo and metalF0
  Texture roughness = 0.5;   ///< in [0.02, 1]; GGX alpha is its square
  Texture bump;              ///< height, m
};

/// Values of QUELL_SHAPE_*.
enum class Shape {
  Sphere = QUELL_SHAPE_SPHERE,
  Box = QUELL_SHAPE_BOX,
  Rectangle = QUELL_SHAPE_RECTANGLE,
  Disc = QUELL_SHAPE_DISC,
  Cylinder = QUELL_SHAPE_CYLINDER,
  Torus = QUELL_SHAPE_TORUS,
  RoundedBox = QUELL_SHAPE_ROUNDED_BOX,
};

/// Where a shape stands: first rotated, then moved.
struct Pose {
  glm::dvec3 position{0.0};
  glm::dmat3 rotation{1.0};  ///< orthonormal, determinant 1

  Pose() = default;
  Pose(const glm::dvec3& p) : position(p) {}
  Pose(const glm::dvec3& p, const glm::dmat3& r) : position(p), rotation(r) {}
};

/// Rotation by an angle about an axis (any length but 0), counter-clockwise seen against the axis.
glm::dmat3 rotationAbout(const glm::dvec3& axis, double angleDeg);
/// A rotation that takes +z to `direction` (any length but 0): rectangles and discs then face it.
glm::dmat3 facing(const glm::dvec3& direction);

struct Object {
  Shape shape = Shape::Sphere;
  glm::dvec4 size{1.0};  ///< m, as QUELL_SHAPE_* says
  Pose pose;
  int material = 0;  ///< index into Scene::materials
  int id = 0;        ///< >= 1
};

/// Light from everywhere. The sun is a disc of constant radiance.
struct Sky {
  glm::dvec3 zenith{0.0};
  glm::dvec3 horizon{0.0};
  glm::dvec3 ground{0.0};
  glm::dvec3 sunDirection{0.0, 0.0, 1.0};  ///< towards the sun, any length but 0
  glm::dvec3 sunIrradiance{0.0};           ///< on a surface that faces it; 0: no sun
  double sunRadiusDeg = 1.0;               ///< angle; at least 0.5, where single precision still resolves it
};

/// Filled by the scenes' functions; everything is in the order of addition, which must be the same in every frame.
class Scene {
 public:
  PinholeCamera camera;
  Sky sky;

  /// Returns the index of the material.
  int add(const Material& material);

  /// Adds shapes. A material with emission makes a light of it: only spheres and rectangles (on their +z side) may.
  /// Each call is an object of its own unless `partOf` names another's id. Returns the object's id.
  /// Throws std::invalid_argument for a light of another shape or a size that is not positive.
  int sphere(const Pose& pose, double radius, int material, int partOf = 0);
  int box(const Pose& pose, const glm::dvec3& halfExtents, int material, int partOf = 0);
  int rectangle(const Pose& pose, double halfX, double halfY, int material, int partOf = 0);
  int disc(const Pose& pose, double halfAxisX, double halfAxisY, int material, int partOf = 0);
  int cylinder(const Pose& pose, double radius, double halfHeight, int material, int partOf = 0);
  int torus(const Pose& pose, double radius, double tubeRadius, int material, int partOf = 0);
  int roundedBox(const Pose& pose, const glm::dvec3& halfExtents, double edgeRadius, int material,
                 int partOf = 0);

  const std::vector<Material>& materials() const { return m_materials; }
  const std::vector<Object>& objects() const { return m_objects; }

 private:
  int addObject(Shape shape, const Pose& pose, const glm::dvec4& size, int material, int partOf);

  std::vector<Material> m_materials;
  std::vector<Object> m_objects;
  int m_lastId = 0;
};

}  // namespace quell::render

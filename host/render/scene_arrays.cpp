#include "host/render/scene_arrays.hpp"

#include <cmath>
#include <stdexcept>

#include "host/render/bvh.hpp"
#include "host/render/pack.hpp"

namespace quell::render {
namespace {

constexpr double kPi = 3.14159265358979323846;
// Cosine that no direction reaches.
constexpr double kNoSun = 2.0;

bool isBlack(const glm::dvec3& color) { return glm::dot(color, color) == 0.0; }

/// Half extents of a box about the origin that holds the shape, object space.
glm::dvec3 halfExtents(const Object& object) {
  const glm::dvec4& s = object.size;
  switch (object.shape) {
    case Shape::Sphere:
      return glm::dvec3(s.x);
    case Shape::Rectangle:
    case Shape::Disc:
      return {s.x, s.y, 0.0};
    case Shape::Cylinder:
      return {s.x, s.x, s.y};
    case Shape::Torus:
      return {s.x + s.y, s.x + s.y, s.y};
    case Shape::Box:
    case Shape::RoundedBox:
      return {s.x, s.y, s.z};
  }
  return glm::dvec3(0.0);
}

Bounds boundsOf(const Object& object) {
  const glm::dvec3 half = halfExtents(object);
  glm::dvec3 world(0.0);
  for (int axis = 0; axis < 3; ++axis) world += half[axis] * glm::abs(object.pose.rotation[axis]);
  return {object.pose.position - world, object.pose.position + world};
}

void packPose(const Pose& pose, QuellFloat4* rows) {
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 row = pose.rotation[axis];  // the inverse of a rotation is its transpose
    rows[axis] = pack(row, -glm::dot(row, pose.position));
  }
}

RenderTexture packTexture(const Texture& texture) {
  return {int(texture.pattern), float(texture.scale), float(texture.low), float(texture.high)};
}

RenderMaterial packMaterial(const Material& material) {
  RenderMaterial packed{};
  packed.albedoA = pack(material.albedoA);
  packed.albedoB = pack(material.albedoB);
  packed.f0A = pack(material.f0);
  packed.f0B = pack(material.metalF0);
  packed.tint = pack(material.tint);
  packed.emission = pack(material.emission);
  packed.albedoTexture = packTexture(material.pattern);
  packed.metalTexture = packTexture(material.metal);
  packed.roughnessTexture = packTexture(material.roughness);
  packed.bumpTexture = packTexture(material.bump);
  return packed;
}

RenderLight packLight(const Object& object, const Material& material) {
  RenderLight light{};
  light.radiance = pack(material.emission);
  if (object.shape == Shape::Sphere) {
    light.type = QUELL_LIGHT_SPHERE;
    light.center = pack(object.pose.position, object.size.x);
    return light;
  }
  light.type = QUELL_LIGHT_RECTANGLE;
  light.center = pack(object.pose.position);
  light.axisU = pack(object.size.x * object.pose.rotation[0]);
  light.axisV = pack(object.size.y * object.pose.rotation[1]);
  light.normal = pack(object.pose.rotation[2], 4.0 * object.size.x * object.size.y);
  return light;
}

RenderSky packSky(const Sky& sky) {
  RenderSky packed{};
  packed.zenith = pack(sky.zenith);
  packed.horizon = pack(sky.horizon);
  packed.ground = pack(sky.ground);
  const bool sun = !isBlack(sky.sunIrradiance);
  const double radius = sky.sunRadiusDeg * kPi / 180.0;
  packed.sun = pack(glm::normalize(sky.sunDirection), sun ? std::cos(radius) : kNoSun);
  // Irradiance of a disc of radiance L that is seen under the angle 2r: pi L sin(r)^2.
  if (sun) packed.sunRadiance = pack(sky.sunIrradiance / (kPi * std::sin(radius) * std::sin(radius)));
  return packed;
}

void addDistantLights(const Sky& sky, SceneArrays& arrays) {
  if (!isBlack(sky.sunIrradiance)) {
    RenderLight sun{};
    sun.type = QUELL_LIGHT_SUN;
    sun.center = arrays.sky.sun;
    sun.radiance = arrays.sky.sunRadiance;
    arrays.sunLight = int(arrays.lights.size());
    arrays.lights.push_back(sun);
  }
  if (!isBlack(sky.zenith + sky.horizon + sky.ground)) {
    RenderLight light{};
    light.type = QUELL_LIGHT_SKY;
    arrays.skyLight = int(arrays.lights.size());
    arrays.lights.push_back(light);
  }
}

}  // namespace

SceneArrays makeSceneArrays(const Scene& now, const Scene& before) {
  const std::vector<Object>& objects = now.objects();
  if (objects.empty()) throw std::invalid_argument("a scene without objects");
  if (objects.size() != before.objects().size())
    throw std::invalid_argument("a scene whose number of objects changes");
  SceneArrays arrays;
  for (const Material& material : now.materials()) arrays.materials.push_back(packMaterial(material));

  std::vector<RenderPrimitive> primitives;
  std::vector<Bounds> bounds;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Object& object = objects[i];
    const Material& material = now.materials()[std::size_t(object.material)];
    RenderPrimitive primitive{};
    packPose(object.pose, primitive.toObject);
    packPose(before.objects()[i].pose, primitive.toObjectPrev);
    primitive.size = {float(object.size.x), float(object.size.y), float(object.size.z), float(object.size.w)};
    primitive.shape = int(object.shape);
    primitive.material = object.material;
    primitive.objectId = object.id;
    primitive.light = -1;
    if (!isBlack(material.emission)) {
      primitive.light = int(arrays.lights.size());
      arrays.lights.push_back(packLight(object, material));
    }
    primitives.push_back(primitive);
    bounds.push_back(boundsOf(object));
  }
  Bvh bvh = buildBvh(bounds);
  arrays.nodes = std::move(bvh.nodes);
  for (const int index : bvh.order) arrays.primitives.push_back(primitives[std::size_t(index)]);

  arrays.sky = packSky(now.sky);
  addDistantLights(now.sky, arrays);
  for (RenderLight& light : arrays.lights) light.probability = 1.0f / float(arrays.lights.size());
  return arrays;
}

}  // namespace quell::render

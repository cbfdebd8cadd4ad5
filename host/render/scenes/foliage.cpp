// foliage: bushes of thousands of leaves and grass at dusk: normals and depths change from pixel to pixel, and little light.
#include <cmath>

#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"
#include "host/render/scenes/props.hpp"

namespace quell::render {
namespace {

constexpr int kLeavesPerBush = 640;
constexpr int kBlades = 1100;

void addBush(Scene& scene, const glm::dvec3& center, double radius, int leaf, int bark, SceneRandom& random) {
  const int id = scene.cylinder({{center.x, center.y, 0.5 * center.z}}, 0.07 * radius, 0.5 * center.z, bark);
  for (int i = 0; i < kLeavesPerBush; ++i) {
    const glm::dvec3 outward = random.direction();
    const double depth = std::cbrt(random.uniform(0.25, 1.0));
    const glm::dvec3 place = center + radius * depth * outward * glm::dvec3(1.0, 1.0, 0.85);
    const glm::dvec3 normal = outward + glm::dvec3(0.0, 0.0, 0.6) + 0.8 * random.direction();
    const glm::dmat3 turn = rotationAbout({0.0, 0.0, 1.0}, random.uniform(0.0, 360.0));
    const double length = radius * random.uniform(0.085, 0.15);
    scene.disc({place, facing(normal) * turn}, length, 0.45 * length, leaf, id);
  }
}

void addGrass(Scene& scene, int material, SceneRandom& random) {
  int id = 0;
  for (int i = 0; i < kBlades; ++i) {
    const double height = random.uniform(0.06, 0.2);  // m
    const glm::dvec3 foot(random.uniform(-4.0, 4.0), random.uniform(-2.9, 3.0), 0.8 * height);
    const glm::dvec3 tilt(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 0.0);
    const glm::dvec3 normal(std::cos(0.7 * i), std::sin(0.7 * i), 0.0);
    const glm::dmat3 pose = rotationAbout({tilt.y, -tilt.x, 1e-9}, 57.3 * glm::length(tilt)) * facing(normal);
    id = scene.disc({foot, pose}, 0.009, height, material, id);
  }
}

}  // namespace

void foliage(Scene& scene, double frame) {
  const double angle = -1.62 + 0.006 * frame;
  scene.camera.eye = {5.6 * std::cos(angle), 5.6 * std::sin(angle), 1.25};
  scene.camera.target = {0.0, 0.3, 0.85};
  scene.camera.fieldOfViewDeg = 38.0;
  scene.sky.zenith = {0.05, 0.09, 0.2};
  scene.sky.horizon = {0.32, 0.22, 0.2};
  scene.sky.ground = {0.03, 0.03, 0.03};

  Material soil = matte({0.10, 0.13, 0.05});
  soil.albedoB = {0.2, 0.14, 0.08};
  soil.pattern = {Pattern::Patches, 1.1};
  soil.bump = {Pattern::Noise, 5.0, 0.0, 0.05};
  const int ground = scene.add(soil);
  const int bark = scene.add(matte({0.17, 0.11, 0.07}));
  const int dark = scene.add(glazed({0.08, 0.22, 0.05}, 0.4));
  const int light = scene.add(glazed({0.25, 0.34, 0.07}, 0.5));
  const int autumn = scene.add(glazed({0.48, 0.19, 0.05}, 0.45));
  const int grass = scene.add(matte({0.16, 0.3, 0.07}));
  const int lantern = scene.add(emitter({130.0, 82.0, 38.0}));

  scene.rectangle({{0.0, 0.0, 0.0}}, 20.0, 20.0, ground);
  SceneRandom random(7);
  addBush(scene, {-1.5, 0.3, 0.85}, 0.75, dark, bark, random);
  addBush(scene, {0.1, 1.2, 1.1}, 0.95, light, bark, random);
  addBush(scene, {1.6, 0.4, 0.8}, 0.7, autumn, bark, random);
  addBush(scene, {-0.5, -1.1, 0.42}, 0.4, light, bark, random);
  addBush(scene, {2.9, 1.9, 1.2}, 1.0, dark, bark, random);
  addBush(scene, {-3.1, 2.0, 1.25}, 1.05, autumn, bark, random);
  addGrass(scene, grass, random);
  scene.cylinder({{0.75, -0.5, 0.45}}, 0.025, 0.45, bark);
  scene.sphere({{0.75, -0.5, 1.0}}, 0.1, lantern);
}

}  // namespace quell::render

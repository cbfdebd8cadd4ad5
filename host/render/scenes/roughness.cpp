// roughness: a studio of spheres, tori and rounded boxes in metal and glaze. Roughness and F0 vary within every object
// and the camera orbits, so F_beta takes all its values: what demodulation of the glossy light has to cope with.
#include <array>
#include <cmath>

#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"

namespace quell::render {
namespace {

constexpr double kPi = 3.14159265358979323846;

// The orbit: radius and height (m), start and speed.
constexpr double kOrbitM = 6.9;
constexpr double kEyeHeightM = 2.7;
constexpr double kStartDeg = -104.0;
constexpr double kDegPerFrame = 0.5;

// Roughness of all maps.
constexpr double kSmooth = 0.05;
constexpr double kRough = 0.8;

void addRoom(Scene& scene) {
  Material floor = glazed({0.34, 0.33, 0.31}, {Pattern::Tiles, 1.4, 0.08, 0.55});
  floor.albedoB = {0.52, 0.5, 0.46};
  floor.pattern = {Pattern::Checker, 1.4};
  const int tiles = scene.add(floor);
  Material wall = glazed({0.45, 0.47, 0.5}, {Pattern::Noise, 1.2, 0.2, kRough});
  wall.albedoB = {0.55, 0.42, 0.33};
  wall.pattern = {Pattern::Bricks, 3.0, 0.0, 1.0};
  wall.bump = {Pattern::Bricks, 3.0, 0.0, 0.015};
  const int brick = scene.add(wall);
  scene.rectangle({{0.0, 0.0, 0.0}}, 9.0, 9.0, tiles);
  scene.rectangle({{0.0, 4.0, 2.5}, facing({0.0, -1.0, 0.0})}, 7.0, 2.5, brick);
  scene.rectangle({{-5.5, 0.0, 2.5}, facing({1.0, 0.0, 0.0})}, 7.0, 2.5, brick);
}

void addLights(Scene& scene) {
  const int warm = scene.add(emitter({30.0, 23.5, 17.0}));
  const int cool = scene.add(emitter({15.0, 19.5, 26.0}));
  const int white = scene.add(emitter({20.0, 20.0, 19.0}));
  scene.rectangle({{-2.2, -0.6, 4.6}, facing({0.25, 0.1, -1.0})}, 0.7, 0.5, warm);
  scene.rectangle({{2.8, -1.4, 4.3}, facing({-0.5, 0.2, -1.0})}, 0.6, 0.6, cool);
  scene.rectangle({{0.6, 2.4, 4.8}, facing({0.0, -0.3, -1.0})}, 1.2, 0.25, white);
  scene.sky.zenith = {0.10, 0.12, 0.16};
  scene.sky.horizon = {0.22, 0.23, 0.25};
  scene.sky.ground = {0.10, 0.09, 0.08};
}

/// Metal that shows where the paint is worn off.
Material wornPaint(const glm::dvec3& paint, const glm::dvec3& f0, double scale) {
  Material material = glazed(paint, {Pattern::Noise, 2.0 * scale, 0.1, 0.7});
  material.metalF0 = f0;
  material.metal = {Pattern::Patches, scale};
  return material;
}

/// Metals from polished to blasted, one map each.
void addFrontRow(Scene& scene) {
  struct Item {
    glm::dvec3 f0;
    Texture roughness;
  };
  const std::array<Item, 5> items = {{{kGold, {Pattern::Ramp, 0.8, kSmooth, 0.6}},
                                      {kCopper, {Pattern::Noise, 4.0, kSmooth, kRough}},
                                      {kSilver, {Pattern::Stripes, 3.0, kSmooth, 0.4}},
                                      {kIron, {Pattern::Patches, 3.0, 0.15, kRough}},
                                      {kBrass, {Pattern::Tiles, 5.0, kSmooth, kRough}}}};
  for (std::size_t i = 0; i < items.size(); ++i) {
    const int material = scene.add(metal(items[i].f0, items[i].roughness));
    scene.sphere({{-2.6 + 1.3 * double(i), -1.2 - 0.15 * double(i % 2), 0.55}}, 0.55, material);
  }
}

void addMiddleRow(Scene& scene) {
  const int red = scene.add(glazed({0.6, 0.08, 0.06}, {Pattern::Ramp, 0.6, kSmooth, 0.5}));
  const int worn = scene.add(wornPaint({0.06, 0.25, 0.45}, kAluminium, 2.5));
  const int green = scene.add(wornPaint({0.12, 0.4, 0.14}, kCopper, 1.8));
  const int gold = scene.add(metal(kGold, {Pattern::Noise, 3.0, 0.1, 0.5}));
  Material veined = glazed({0.7, 0.68, 0.64}, {Pattern::Marble, 0.8, 0.05, 0.35});
  veined.albedoB = {0.15, 0.17, 0.2};
  veined.pattern = {Pattern::Marble, 0.8};
  const int marble = scene.add(veined);
  scene.roundedBox({{-2.3, 0.9, 0.7}, rotationAbout({0.0, 0.0, 1.0}, 25.0)}, {0.6, 0.6, 0.7}, 0.15, worn);
  scene.torus({{-0.4, 0.7, 0.95}, facing({0.35, -1.0, 0.25})}, 0.65, 0.28, gold);
  scene.sphere({{1.2, 0.6, 0.7}}, 0.7, red);
  scene.roundedBox({{2.9, 0.9, 0.55}, rotationAbout({0.0, 0.0, 1.0}, -15.0)}, {0.5, 0.5, 0.55}, 0.08, marble);
  scene.cylinder({{-3.9, 2.2, 1.2}}, 0.45, 1.2, green);
  scene.sphere({{-3.9, 2.2, 2.85}}, 0.45, red);
  scene.cylinder({{0.4, 2.6, 0.9}}, 0.5, 0.9, marble);
  scene.sphere({{0.4, 2.6, 2.35}}, 0.55, worn);
  scene.cylinder({{3.9, 2.5, 0.6}}, 0.6, 0.6, green);
  scene.torus({{3.9, 2.5, 1.45}}, 0.45, 0.25, gold);
}

}  // namespace

void roughness(Scene& scene, double frame) {
  const double angle = (kStartDeg + kDegPerFrame * frame) * kPi / 180.0;
  scene.camera.target = {0.0, 0.5, 0.75};
  scene.camera.eye = {kOrbitM * std::cos(angle), 0.5 + kOrbitM * std::sin(angle), kEyeHeightM};
  scene.camera.fieldOfViewDeg = 40.0;
  addRoom(scene);
  addLights(scene);
  addFrontRow(scene);
  addMiddleRow(scene);
}

}  // namespace quell::render

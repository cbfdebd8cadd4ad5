// moving-objects: rolling, spinning, sliding and circling objects under a panning camera: history must follow the objects,
// which the matrices of the camera alone cannot.
#include <cmath>

#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"
#include "host/render/scenes/props.hpp"

namespace quell::render {
namespace {

constexpr double kTurn = 6.283185307179586;

Material checked(const glm::dvec3& a, const glm::dvec3& b, double scale, double roughness) {
  Material material = glazed(a, roughness);
  material.albedoB = b;
  material.pattern = {Pattern::Checker, scale};
  return material;
}

/// To and fro between -1 and 1 with smooth ends.
double swing(double frame, double period) { return std::sin(kTurn * frame / period); }

void addCarousel(Scene& scene, double frame) {
  const int post = scene.add(glazed({0.2, 0.2, 0.25}, 0.3));
  const int gold = scene.add(metal(kGold, 0.2));
  const int red = scene.add(glazed({0.6, 0.07, 0.06}, 0.3));
  const glm::dvec3 center(2.0, 1.2, 0.0);
  scene.cylinder({center + glm::dvec3(0.0, 0.0, 0.75)}, 0.08, 0.75, post);
  for (int i = 0; i < 6; ++i) {
    const double angle = kTurn * (i / 6.0 + frame / 90.0);
    const glm::dvec3 arm(std::cos(angle), std::sin(angle), 0.0);
    const int id =
        scene.cylinder({center + 0.45 * arm + glm::dvec3(0.0, 0.0, 1.4), facing(arm)}, 0.025, 0.45, post);
    scene.sphere({center + 0.9 * arm + glm::dvec3(0.0, 0.0, 1.25)}, 0.2, i % 2 == 0 ? gold : red, id);
  }
}

}  // namespace

void movingObjects(Scene& scene, double frame) {
  const double pan = 0.3 * swing(frame, 140.0);
  scene.camera.eye = {pan, -5.4, 2.0};
  scene.camera.target = {0.6 * pan, 0.2, 0.75};
  scene.camera.fieldOfViewDeg = 42.0;
  scene.sky.zenith = {0.3, 0.4, 0.6};
  scene.sky.horizon = {0.55, 0.55, 0.55};
  scene.sky.ground = {0.2, 0.2, 0.2};
  scene.sky.sunDirection = {-0.6, -0.7, 1.0};
  scene.sky.sunIrradiance = {2.3, 2.0, 1.6};
  scene.sky.sunRadiusDeg = 2.0;

  Material ground = glazed({0.45, 0.44, 0.42}, {Pattern::Noise, 1.5, 0.2, 0.5});
  ground.albedoB = {0.3, 0.32, 0.36};
  ground.pattern = {Pattern::Tiles, 1.0};
  scene.rectangle({{0.0, 0.0, 0.0}}, 12.0, 12.0, scene.add(ground));
  Material brick = matte({0.55, 0.52, 0.48});
  brick.albedoB = {0.45, 0.25, 0.18};
  brick.pattern = {Pattern::Bricks, 4.0};
  scene.rectangle({{0.0, 3.2, 1.2}, facing({0.0, -1.0, 0.0})}, 6.0, 1.2, scene.add(brick));

  // Rolls without slipping: a path of x metres turns it by x / radius.
  const double rolled = 1.3 * swing(frame, 60.0);
  const int ball = scene.add(checked({0.7, 0.65, 0.6}, {0.1, 0.2, 0.5}, 4.0, 0.25));
  scene.sphere({{-0.4 + rolled, -1.2, 0.4}, rotationAbout({0.0, 1.0, 0.0}, 57.29577951308232 * rolled / 0.4)},
               0.4, ball);
  const int die = scene.add(checked({0.75, 0.3, 0.1}, {0.7, 0.65, 0.5}, 5.0, 0.3));
  scene.roundedBox(
      {{-2.1, 0.6, 0.75},
       rotationAbout({0.0, 0.0, 1.0}, 4.0 * frame) * rotationAbout({1.0, 1.0, 0.0}, 2.5 * frame)},
      {0.42, 0.42, 0.42}, 0.08, die);
  const int ring = scene.add(metal(kCopper, {Pattern::Stripes, 4.0, 0.1, 0.4}));
  scene.torus({{0.1, 0.9, 1.15}, rotationAbout({0.3, 0.2, 1.0}, 5.0 * frame) * facing({1.0, 0.3, 0.2})}, 0.55,
              0.17, ring);
  const int striped = scene.add(checked({0.15, 0.4, 0.2}, {0.6, 0.6, 0.5}, 3.0, 0.4));
  scene.cylinder({{-0.6 + 1.8 * swing(frame + 20.0, 80.0), 2.2, 0.7}}, 0.3, 0.7, striped);
  scene.box({{0.9, -0.6, 0.3 + 0.25 * (1.0 + swing(frame, 40.0))}}, {0.3, 0.3, 0.3},
            scene.add(checked({0.55, 0.5, 0.1}, {0.2, 0.2, 0.22}, 3.0, 0.5)));
  addCarousel(scene, frame);
}

}  // namespace quell::render

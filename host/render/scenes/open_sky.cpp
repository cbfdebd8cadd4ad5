// open-sky: balloons, masts and hills before a wide sky: most of the frame is background, which costs nothing to denoise.
#include <cmath>

#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"
#include "host/render/scenes/props.hpp"

namespace quell::render {

void openSky(Scene& scene, double frame) {
  const double heading = -0.12 + 0.004 * frame;
  scene.camera.eye = {0.02 * frame, -9.0, 1.8};
  scene.camera.target = scene.camera.eye + glm::dvec3(std::sin(heading), std::cos(heading), 0.27);
  scene.camera.fieldOfViewDeg = 46.0;
  scene.sky.zenith = {0.16, 0.34, 0.8};
  scene.sky.horizon = {0.85, 0.85, 0.82};
  scene.sky.ground = {0.2, 0.22, 0.15};
  scene.sky.sunDirection = {0.9, -0.5, 0.9};
  scene.sky.sunIrradiance = {3.8, 3.4, 2.8};

  Material meadow = matte({0.2, 0.3, 0.08});
  meadow.albedoB = {0.36, 0.34, 0.14};
  meadow.pattern = {Pattern::Noise, 0.4};
  meadow.bump = {Pattern::Noise, 1.5, 0.0, 0.08};
  const int grass = scene.add(meadow);
  scene.rectangle({{0.0, 40.0, 0.0}}, 120.0, 60.0, grass);
  scene.sphere({{-22.0, 45.0, -52.0}}, 56.0, grass);
  scene.sphere({{26.0, 60.0, -74.0}}, 79.0, grass);

  const auto balloon = [&](const glm::dvec3& place, double radius, const glm::dvec3& a, const glm::dvec3& b) {
    Material cloth = glazed(a, 0.5);
    cloth.albedoB = b;
    cloth.pattern = {Pattern::Stripes, 1.2 / radius};
    const int material = scene.add(cloth);
    const int id = scene.sphere({place}, radius, material);
    const int rope = scene.add(matte({0.25, 0.18, 0.1}));
    for (const double x : {-0.25, 0.25})
      scene.cylinder({place + glm::dvec3(x * radius, 0.0, -1.35 * radius)}, 0.012, 0.42 * radius, rope, id);
    scene.box({place - glm::dvec3(0.0, 0.0, 1.9 * radius)}, glm::dvec3(0.28, 0.28, 0.2) * radius, rope, id);
  };
  balloon({-2.6, 3.0, 5.0}, 1.1, {0.65, 0.1, 0.08}, {0.75, 0.65, 0.2});
  balloon({2.4, 7.0, 6.6}, 1.2, {0.1, 0.25, 0.6}, {0.7, 0.7, 0.7});
  balloon({5.6, 12.0, 4.8}, 1.3, {0.15, 0.45, 0.2}, {0.8, 0.75, 0.5});

  const int steel = scene.add(metal(kAluminium, 0.35));
  const int flag = scene.add(matte({0.65, 0.2, 0.1}));
  for (int i = 0; i < 5; ++i) {
    const double x = -3.2 + 1.7 * i;
    const double height = 2.6 + 0.5 * ((i * 3) % 4);
    const int id = scene.cylinder({{x, 0.6 * i, 0.5 * height}}, 0.03, 0.5 * height, steel);
    scene.disc({{x + 0.28, 0.6 * i, height - 0.2}, facing({0.25, -1.0, 0.1})}, 0.26, 0.16, flag, id);
  }
}

}  // namespace quell::render

// mirror: metals and a floor of roughness 0.02 to 0.15: what is seen in them moves differently from their surfaces.
#include <cmath>

#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"
#include "host/render/scenes/props.hpp"

namespace quell::render {

void mirror(Scene& scene, double frame) {
  const double angle = -1.75 + 0.008 * frame;
  scene.camera.eye = {5.2 * std::cos(angle), 5.2 * std::sin(angle), 1.7};
  scene.camera.target = {0.0, 0.2, 0.75};
  scene.camera.fieldOfViewDeg = 42.0;
  scene.sky.zenith = {0.2, 0.25, 0.35};
  scene.sky.horizon = {0.4, 0.4, 0.4};
  scene.sky.ground = {0.1, 0.1, 0.1};

  const int floor = scene.add(metal({0.35, 0.36, 0.38}, {Pattern::Tiles, 1.2, 0.02, 0.1}));
  Material checks = matte({0.7, 0.68, 0.6});
  checks.albedoB = {0.08, 0.25, 0.45};
  checks.pattern = {Pattern::Checker, 1.5};
  const int wall = scene.add(checks);
  Material stripes = matte({0.7, 0.25, 0.12});
  stripes.albedoB = {0.75, 0.6, 0.25};
  stripes.pattern = {Pattern::Stripes, 1.0};
  const int side = scene.add(stripes);
  const int grey = scene.add(matte({0.5, 0.5, 0.5}));
  addRoom(scene, {-4.5, -6.5, 0.0}, {4.5, 3.2, 3.6}, {floor, -1, side, side, wall, grey});

  const int lamp = scene.add(emitter({9.0, 8.5, 8.0}));
  scene.rectangle({{-1.6, -0.6, 3.5}, facing({0.1, 0.0, -1.0})}, 0.8, 0.5, lamp);
  scene.rectangle({{2.2, -1.6, 3.4}, facing({-0.3, 0.2, -1.0})}, 0.5, 0.8, lamp);

  scene.sphere({{-1.5, 0.3, 0.8}}, 0.8, scene.add(metal(kSilver, 0.03)));
  scene.sphere({{0.35, -0.9, 0.45}}, 0.45, scene.add(metal(kGold, 0.08)));
  scene.roundedBox({{1.6, 0.5, 0.7}, rotationAbout({0.0, 0.0, 1.0}, 28.0)}, {0.6, 0.6, 0.7}, 0.1,
                   scene.add(metal(kAluminium, 0.05)));
  scene.torus({{0.2, 1.5, 0.95}, facing({0.1, -1.0, 0.3})}, 0.7, 0.22,
              scene.add(metal(kCopper, {Pattern::Noise, 2.0, 0.03, 0.15})));
  scene.cylinder({{-0.5, -1.4, 0.3}}, 0.3, 0.3, scene.add(glazed({0.1, 0.4, 0.15}, 0.04)));
  scene.sphere({{2.4, -1.0, 0.35}}, 0.35, scene.add(glazed({0.6, 0.06, 0.05}, 0.03)));
  scene.rectangle({{-3.2, 1.6, 1.3}, facing({0.8, -1.0, 0.0})}, 0.8, 1.2, scene.add(metal(kSilver, 0.02)));
}

}  // namespace quell::render

// dark: a cellar that a hidden lamp barely lights: most paths find nothing, a few find a lot (fireflies).
#include <cmath>

#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"
#include "host/render/scenes/props.hpp"

namespace quell::render {

void dark(Scene& scene, double frame) {
  scene.camera.eye = {-0.3 + 0.012 * frame, -4.6, 1.45};
  scene.camera.target = {0.25, 0.0, 1.0};
  scene.camera.fieldOfViewDeg = 46.0;

  Material stone = matte({0.42, 0.4, 0.37});
  stone.albedoB = {0.3, 0.26, 0.22};
  stone.pattern = {Pattern::Bricks, 2.5};
  stone.bump = {Pattern::Bricks, 2.5, 0.0, 0.02};
  const int wall = scene.add(stone);
  Material slabs = glazed({0.3, 0.29, 0.27}, {Pattern::Tiles, 1.0, 0.15, 0.5});
  slabs.albedoB = {0.4, 0.36, 0.3};
  slabs.pattern = {Pattern::Tiles, 1.0};
  const int floor = scene.add(slabs);
  addRoom(scene, {-3.0, -5.0, 0.0}, {3.0, 2.5, 2.8}, {floor, wall, wall, wall, wall, wall});

  // The lamp hangs behind a pier and under a hood; nothing that the camera sees is lit by it but the back wall.
  const int lamp = scene.add(emitter({420.0, 290.0, 165.0}));
  scene.sphere({{1.35, 1.9, 1.6}}, 0.05, lamp);
  scene.box({{1.25, 1.25, 1.4}}, {0.55, 0.12, 1.4}, wall);
  scene.box({{0.72, 1.75, 1.5}}, {0.04, 0.45, 0.8}, wall);

  const int barrel = scene.add(glazed({0.3, 0.17, 0.08}, 0.4));
  scene.cylinder({{-1.6, 1.0, 0.55}}, 0.45, 0.55, barrel);
  scene.cylinder({{-0.75, 1.5, 0.55}}, 0.45, 0.55, barrel);
  scene.cylinder({{-1.2, 0.1, 0.42}, facing({1.0, 0.3, 0.0})}, 0.42, 0.5, barrel);
  scene.sphere({{0.35, 0.3, 0.4}}, 0.4, scene.add(metal(kBrass, 0.15)));
  scene.torus({{1.3, 0.0, 0.15}}, 0.4, 0.15, scene.add(metal(kIron, 0.3)));
  scene.roundedBox({{2.2, 0.6, 0.4}, rotationAbout({0.0, 0.0, 1.0}, 15.0)}, {0.4, 0.4, 0.4}, 0.05, barrel);
}

}  // namespace quell::render

// moving-light: camera and objects stand still, a lamp circles over them: shadows and highlights move while no feature does.
#include <cmath>

#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"
#include "host/render/scenes/props.hpp"

namespace quell::render {

void movingLight(Scene& scene, double frame) {
  scene.camera.eye = {0.0, -5.2, 2.1};
  scene.camera.target = {0.0, 0.2, 0.85};
  scene.camera.fieldOfViewDeg = 40.0;
  scene.sky.zenith = {0.05, 0.06, 0.08};
  scene.sky.horizon = {0.05, 0.06, 0.08};
  scene.sky.ground = {0.05, 0.06, 0.08};

  Material boards = glazed({0.42, 0.28, 0.17}, {Pattern::Noise, 2.0, 0.25, 0.5});
  boards.albedoB = {0.3, 0.18, 0.1};
  boards.pattern = {Pattern::Stripes, 3.0};
  const int floor = scene.add(boards);
  Material paper = matte({0.55, 0.53, 0.46});
  paper.albedoB = {0.4, 0.45, 0.42};
  paper.pattern = {Pattern::Stripes, 1.5};
  const int wall = scene.add(paper);
  const int white = scene.add(matte({0.7, 0.69, 0.67}));
  addRoom(scene, {-3.4, -5.6, 0.0}, {3.4, 2.4, 3.2}, {floor, white, wall, wall, wall, -1});

  const double angle = 6.283185307179586 * frame / 48.0;
  const int lamp = scene.add(emitter({95.0, 77.0, 54.0}));
  scene.sphere({{1.5 * std::cos(angle), 0.2 + 0.9 * std::sin(angle), 2.35}}, 0.16, lamp);

  const int wood = scene.add(glazed({0.25, 0.13, 0.07}, 0.3));
  addTable(scene, {0.0, 0.3, 0.0}, {0.9, 0.55, 0.7}, wood);
  scene.sphere({{-0.4, 0.3, 0.93}}, 0.23, scene.add(metal(kCopper, {Pattern::Noise, 4.0, 0.12, 0.4})));
  scene.roundedBox({{0.35, 0.4, 0.87}, rotationAbout({0.0, 0.0, 1.0}, 30.0)}, {0.17, 0.17, 0.17}, 0.04,
                   scene.add(glazed({0.1, 0.3, 0.5}, 0.2)));
  const int clay = scene.add(matte({0.6, 0.3, 0.2}));
  scene.cylinder({{-1.9, 0.7, 0.8}}, 0.3, 0.8, white);
  scene.torus({{-1.9, 0.7, 1.75}, facing({0.4, -1.0, 0.5})}, 0.28, 0.1, clay);
  scene.box({{1.9, 0.8, 0.55}, rotationAbout({0.0, 0.0, 1.0}, -20.0)}, {0.35, 0.35, 0.55}, white);
  scene.sphere({{1.9, 0.8, 1.38}}, 0.28, clay);
  addRailing(scene, {-3.0, 2.0, 0.0}, {3.0, 2.0, 0.0}, 1.0, 24, wood);
  scene.sphere({{-1.0, -1.3, 0.25}}, 0.25, scene.add(glazed({0.6, 0.55, 0.1}, 0.15)));
  scene.torus({{1.0, -1.2, 0.12}}, 0.3, 0.12, scene.add(metal(kSilver, 0.25)));
}

}  // namespace quell::render

// cornell: the box of Goral et al. 1984, as wide as the image: diffuse, one light, colour bleeding, no background.
#include <cmath>

#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"
#include "host/render/scenes/props.hpp"

namespace quell::render {

void cornell(Scene& scene, double frame) {
  const double sway = 0.45 * std::sin(6.283185307179586 * frame / 96.0);  // m
  scene.camera.eye = {sway, -3.35, 1.05};
  scene.camera.target = {0.3 * sway, 0.0, 0.95};
  scene.camera.fieldOfViewDeg = 42.0;

  const int white = scene.add(matte({0.73, 0.72, 0.70}));
  RoomMaterials walls{
      white, white, scene.add(matte({0.62, 0.06, 0.05})), scene.add(matte({0.12, 0.43, 0.09})), white, white};
  addRoom(scene, {-1.7, -3.5, 0.0}, {1.7, 1.4, 2.0}, walls);
  const int lamp = scene.add(emitter({24.0, 18.5, 11.5}));
  scene.rectangle({{0.0, 0.1, 1.98}, facing({0.0, 0.0, -1.0})}, 0.45, 0.3, lamp);
  const auto turned = [](double degrees) { return rotationAbout({0.0, 0.0, 1.0}, degrees); };
  scene.box({{-0.6, 0.55, 0.62}, turned(18.0)}, {0.3, 0.3, 0.62}, white);
  scene.box({{0.55, -0.15, 0.3}, turned(-20.0)}, {0.3, 0.3, 0.3}, white);
  scene.sphere({{-0.75, -0.55, 0.22}}, 0.22, scene.add(matte({0.25, 0.35, 0.6})));
}

}  // namespace quell::render

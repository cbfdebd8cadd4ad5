// light-switch: at one frame the ceiling light goes out and a standing lamp goes on: all history is wrong at once, and
// no feature tells.
#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"
#include "host/render/scenes/still_room.hpp"

namespace quell::render {

void lightSwitch(Scene& scene, double frame) {
  addStillRoom(scene);
  scene.sky.zenith = {0.05, 0.08, 0.16};
  scene.sky.horizon = {0.10, 0.12, 0.2};
  scene.sky.ground = {0.02, 0.02, 0.02};
  const bool before = frame < kLightSwitchFrame;
  const int ceiling = scene.add(before ? emitter({12.0, 14.0, 17.0}) : matte({0.8, 0.8, 0.8}));
  const int shade = scene.add(before ? matte({0.8, 0.75, 0.65}) : emitter({44.0, 27.0, 12.0}));
  scene.rectangle({{-0.4, -0.8, 2.78}, facing({0.0, 0.0, -1.0})}, 0.6, 0.4, ceiling);
  const int stand = scene.cylinder({{-1.5, -0.4, 0.65}}, 0.025, 0.65, scene.add(metal(kBrass, 0.3)));
  scene.sphere({{-1.5, -0.4, 1.45}}, 0.17, shade, stand);
}

}  // namespace quell::render

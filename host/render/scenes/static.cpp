// static: nothing moves and nothing changes: what still flickers after denoising is temporal error.
#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"
#include "host/render/scenes/still_room.hpp"

namespace quell::render {

void staticRoom(Scene& scene, double) {
  addStillRoom(scene);
  scene.sky.zenith = {0.6, 0.8, 1.2};
  scene.sky.horizon = {1.0, 1.05, 1.1};
  scene.sky.ground = {0.5, 0.5, 0.4};
  scene.sky.sunDirection = {1.6, -0.7, 1.0};
  scene.sky.sunIrradiance = {11.0, 9.6, 7.5};
  scene.rectangle({{-0.4, -1.2, 2.78}, facing({0.0, 0.0, -1.0})}, 0.5, 0.5,
                  scene.add(emitter({12.0, 11.5, 10.5})));
}

}  // namespace quell::render

#include "host/render/scene_registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <quell/error.hpp>

namespace quell::render {

const std::vector<SceneEntry>& scenes() {
  static const std::vector<SceneEntry> entries = {
      {"cornell", "the diffuse box with one light; the camera sways", cornell},
      {"columns", "colonnade with railings in sun and sky: many edges; the camera walks", columns},
      {"roughness", "roughness maps from 0.05 to 0.8, maps of F0, metals and glazes; the camera orbits",
       roughness},
      {"foliage", "thousands of leaves and blades at dusk; the camera orbits slowly", foliage},
      {"moving-light", "a lamp circles, all else stands still", movingLight},
      {"moving-objects", "rolling, spinning and sliding objects; the camera pans", movingObjects},
      {"open-sky", "balloons and masts: most of the frame is background; the camera turns", openSky},
      {"mirror", "metals and floor of roughness 0.02 to 0.15; the camera orbits", mirror},
      {"dark", "a cellar with a hidden lamp: almost no light, fireflies; the camera slides", dark},
      {"static", "a furnished room; nothing moves or changes", staticRoom},
      {"light-switch", "the same room; at frame 20 one light goes off and another on", lightSwitch,
       kLightSwitchFrame - 1},
  };
  return entries;
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const SceneEntry& entry : scenes()) names.emplace_back(entry.name);
  return names;
}

const SceneEntry& findScene(const std::string& name) {
  for (const SceneEntry& entry : scenes())
    if (name == entry.name) return entry;
  throw Error(ErrorCode::InvalidArgument,
              {"render", "scene", fmt::format("one of {}", fmt::join(sceneNames(), ", ")), name});
}

Scene makeScene(const SceneEntry& entry, int frame) {
  Scene scene;
  entry.describe(scene, frame);
  return scene;
}

}  // namespace quell::render

#include "host/render/scene_registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <quell/error.hpp>

// All scenes: name, what they are for, the function of host/render/scenes/<function>.cpp that describes them at a frame, a
// further frame with references (-1: none).
// clang-format off
#define QUELL_SCENES(SCENE)                                                                                                 \
  SCENE("cornell", "the diffuse box with one light; the camera sways", cornell, -1)                                         \
  SCENE("columns", "colonnade with railings in sun and sky: many edges; the camera walks", columns, -1)                     \
  SCENE("roughness", "roughness maps from 0.05 to 0.8, maps of F0, metals and glazes; the camera orbits", roughness, -1)    \
  SCENE("foliage", "thousands of leaves and blades at dusk; the camera orbits slowly", foliage, -1)                         \
  SCENE("moving-light", "a lamp circles, all else stands still", movingLight, -1)                                           \
  SCENE("moving-objects", "rolling, spinning and sliding objects; the camera pans", movingObjects, -1)                      \
  SCENE("open-sky", "balloons and masts: most of the frame is background; the camera turns", openSky, -1)                   \
  SCENE("mirror", "metals and floor of roughness 0.02 to 0.15; the camera orbits", mirror, -1)                              \
  SCENE("dark", "a cellar with a hidden lamp: almost no light, fireflies; the camera slides", dark, -1)                     \
  SCENE("static", "a furnished room; nothing moves or changes", staticRoom, -1)                                             \
  SCENE("light-switch", "the same room; at frame 20 one light goes off and another on", lightSwitch, kLightSwitchFrame - 1)
// clang-format on

namespace quell::render {

#define QUELL_DECLARE_SCENE(name, purpose, function, frame) void function(Scene& scene, double frameNumber);
QUELL_SCENES(QUELL_DECLARE_SCENE)

const std::vector<SceneEntry>& scenes() {
#define QUELL_SCENE_ENTRY(name, purpose, function, frame) {name, purpose, function, frame},
  static const std::vector<SceneEntry> entries = {QUELL_SCENES(QUELL_SCENE_ENTRY)};
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

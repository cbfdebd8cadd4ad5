#include "host/render/scene_registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <quell/error.hpp>

namespace quell::render {

const std::vector<SceneEntry>& scenes() {
  static const std::vector<SceneEntry> entries = {
      {"roughness",
       "metals and glazes with roughness maps from 0.05 to 0.8 and maps of F0; the camera orbits", roughness},
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

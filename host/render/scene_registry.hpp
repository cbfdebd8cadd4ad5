// The scenes that there are. A new one is one file in scenes/, declared here and listed in
// scene_registry.cpp.
#pragma once

#include <string>
#include <vector>

#include "host/render/scene.hpp"

namespace quell::render {

/// Describes a scene at a time in frames; any number, also -1 for the frame before the first.
using SceneFunction = void (*)(Scene& scene, double frame);

struct SceneEntry {
  const char* name;
  const char* summary;
  SceneFunction describe;
  /// A frame that wants a reference besides the last one (before an event); -1: none.
  int extraReferenceFrame = -1;
};

const std::vector<SceneEntry>& scenes();
std::vector<std::string> sceneNames();

/// Throws Error(InvalidArgument) naming the scenes there are.
const SceneEntry& findScene(const std::string& name);

/// The scene at a frame.
Scene makeScene(const SceneEntry& entry, int frame);

/// First frame of `light-switch` with the other light.
constexpr int kLightSwitchFrame = 20;

}  // namespace quell::render

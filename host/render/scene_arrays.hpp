// A scene as the arrays that the kernels read.
#pragma once

#include <vector>

#include "host/render/scene.hpp"

namespace quell::render {

struct SceneArrays {
  std::vector<RenderBvhNode> nodes;
  std::vector<RenderPrimitive> primitives;  ///< in the order of the tree's leaves
  std::vector<RenderMaterial> materials;
  std::vector<RenderLight> lights;  ///< emitting objects in their order, then sun, then sky; equally probable
  RenderSky sky{};
  int skyLight = -1;
  int sunLight = -1;
};

/// `before` is the scene one frame earlier, with the same objects in the same order.
/// Throws std::invalid_argument if it has not, or if there is no object.
SceneArrays makeSceneArrays(const Scene& now, const Scene& before);

}  // namespace quell::render

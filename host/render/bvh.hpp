// Bounding volume hierarchy over boxes, built by the surface area heuristic in bins (Wald 2007, On fast Construction
// of SAH-based Bounding Volume Hierarchies).
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "kernels/render/scene_params.h"

namespace quell::render {

struct Bounds {
  glm::dvec3 low{1e30};
  glm::dvec3 high{-1e30};

  void include(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  glm::dvec3 center() const { return 0.5 * (low + high); }
  /// Half of the surface area; 0 for nothing.
  double halfArea() const;
};

struct Bvh {
  std::vector<RenderBvhNode> nodes;  ///< the root is the first
  std::vector<int> order;            ///< position in the leaves -> index of the box
};

/// Deterministic. Without boxes there is one empty leaf. The tree never gets deeper than the kernels' stack.
Bvh buildBvh(const std::vector<Bounds>& boxes);

}  // namespace quell::render

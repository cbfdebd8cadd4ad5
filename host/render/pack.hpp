// Vectors of the host as the kernels' parameter structs hold them.
#pragma once

#include <glm/glm.hpp>

#include "kernels/common/types.h"

namespace quell::render {

inline QuellFloat4 pack(const glm::dvec3& v, double w = 0.0) {
  return {float(v.x), float(v.y), float(v.z), float(w)};
}

}  // namespace quell::render

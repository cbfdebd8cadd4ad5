// The furnished room of `static` and `light-switch`.
#pragma once

#include "host/render/scene.hpp"

namespace quell::render {

/// Adds walls, furniture and a camera that stands still, but no light. The right wall has a window.
void addStillRoom(Scene& scene);

}  // namespace quell::render

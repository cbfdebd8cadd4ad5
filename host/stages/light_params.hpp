// What the stages light_sums and light_gain share.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/tiles.hpp"
#include "kernels/light_params.h"

namespace quell {

inline LightParams makeLightParams(const FrameRun& run) {
  LightParams params{};
  params.planes = makePlanes(run.frame.size);
  params.tilesX = tilesAlong(run.frame.size.width);
  params.tilesY = tilesAlong(run.frame.size.height);
  return params;
}

}  // namespace quell

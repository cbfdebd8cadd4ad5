#include "host/stages/tiles.hpp"

#include "kernels/common/tiles_params.h"

namespace quell {

int tilesAlong(int pixels) { return (pixels + QUELL_TILE - 1) / QUELL_TILE; }

int tileCount(Size size, int signals) { return tilesAlong(size.width) * tilesAlong(size.height) * signals; }

std::array<std::size_t, 2> tileRange(Size size) {
  return {static_cast<std::size_t>(tilesAlong(size.width)),
          static_cast<std::size_t>(tilesAlong(size.height))};
}

}  // namespace quell

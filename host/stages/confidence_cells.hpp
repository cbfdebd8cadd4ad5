// The grid of cells of the stage low_confidence.
#pragma once

#include "host/core/round_up.hpp"
#include "host/stages/cell_sizes.hpp"
#include "kernels/low_confidence_params.h"

namespace quell {

/// Cells that cover the image.
inline Size confidenceCells(Size size) {
  return {roundUp(size.width, QUELL_CONFIDENCE_CELL_WIDTH) / QUELL_CONFIDENCE_CELL_WIDTH,
          roundUp(size.height, QUELL_CONFIDENCE_CELL_HEIGHT) / QUELL_CONFIDENCE_CELL_HEIGHT};
}

}  // namespace quell

// The grid of cells of the stage low_confidence.
#pragma once

#include "host/stages/cell_sizes.hpp"
#include "kernels/low_confidence_params.h"

namespace quell {

/// Cells that cover the image.
inline Size confidenceCells(Size size) {
  return cellsCovering(size, {QUELL_CONFIDENCE_CELL_WIDTH, QUELL_CONFIDENCE_CELL_HEIGHT});
}

}  // namespace quell

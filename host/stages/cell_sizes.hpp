// Sizes of buffers that hold planes of a grid that is coarser than the image.
#pragma once

#include "host/core/stage.hpp"

namespace quell {

/// Sets how many cells there are, and how many floats a plane of them takes, margins included; `options` is a struct of
/// QUELL_OPTIONS.
template <class Options>
void setCellSizes(Options& options, Size cells) {
  options.cellCount = cells.width * cells.height;
  options.cellFloats = makePlanes(cells).stride;
}

}  // namespace quell

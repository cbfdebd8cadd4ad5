// Sizes of buffers that hold planes of a grid that is coarser than the image.
#pragma once

#include "host/core/round_up.hpp"
#include "host/core/stage.hpp"

namespace quell {

/// Cells of this size, pixels, that cover the image.
inline Size cellsCovering(Size image, Size cell) {
  return {roundUp(image.width, cell.width) / cell.width, roundUp(image.height, cell.height) / cell.height};
}

/// Work-items of a kernel that takes so many cells of a row each.
inline std::array<std::size_t, 2> cellItems(Size cells, int cellsOfItem) {
  const Size items = cellsCovering(cells, {cellsOfItem, 1});
  return {static_cast<std::size_t>(items.width), static_cast<std::size_t>(items.height)};
}

/// Sets how many cells there are, and how many floats a plane of them takes, margins included; `options` is a struct of
/// QUELL_OPTIONS.
template <class Options>
void setCellSizes(Options& options, Size cells) {
  options.cellCount = cells.width * cells.height;
  options.cellFloats = makePlanes(cells).stride;
}

}  // namespace quell

// The grid of cells that the stages of a guided filter share.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/guided_params.h"

namespace quell {

/// Cells of `subsampling` pixels square that cover the image.
Size guidedCells(Size size, int subsampling);

/// Sets how many cells there are, and how many floats a plane of them takes, margins included; `options` is a struct of
/// QUELL_OPTIONS.
template <class Options>
void setCellSizes(Options& options, Size size, int subsampling) {
  const Size cells = guidedCells(size, subsampling);
  options.cellCount = cells.width * cells.height;
  options.cellFloats = makePlanes(cells).stride;
}

/// `epsilon`: see kernels/guided_params.h.
GuidedParams makeGuidedParams(Size size, int subsampling, double epsilon);

}  // namespace quell

// The grid of cells that the stages of a guided filter share.
#pragma once

#include "host/stages/cell_sizes.hpp"
#include "kernels/guided_params.h"

namespace quell {

/// Cells of `subsampling` pixels square that cover the image.
Size guidedCells(Size size, int subsampling);

/// `epsilon`: see kernels/guided_params.h.
GuidedParams makeGuidedParams(Size size, int subsampling, double epsilon);

}  // namespace quell

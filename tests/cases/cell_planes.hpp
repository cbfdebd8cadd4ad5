// Planes of a grid that is coarser than the image, as buffers of records hold them: each laid out as the planes of an image of
// the grid's size, margins included.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

/// One row of numbers; margins hold something finite that no test expects.
Planes packCells(const Planes& cells);
/// The planes of such a row.
Planes unpackCells(const Planes& packed, Size grid, int count);

}  // namespace quell::tests

// Work-items that show a surface, as kernels/common/surfaces.h has them: one value each, not 0 where one does.
#pragma once

#include <algorithm>

#include "tests/support/planes.hpp"

namespace quell::tests {

/// Of the work-item in this column and row; none outside of the image.
inline bool hasSurface(const Planes& surfaces, int column, int row) {
  return column >= 0 && row >= 0 && column < surfaces.width && row < surfaces.height &&
         surfaces.at(0, column, row) != 0.0f;
}

/// Whether the work-item at pixel (x, y) is within the reach of 3x3 pixels around background that is next to a surface.
inline bool isSeenByAntialiasing(const Planes& surfaces, int lanes, int x, int y) {
  const int first = x / lanes * lanes;
  for (int row = y - 2; row <= y + 2; ++row)
    for (int column = std::max(first - 2, 0); column <= first + lanes + 1; ++column)
      if (hasSurface(surfaces, column / lanes, row)) return true;
  return false;
}

}  // namespace quell::tests

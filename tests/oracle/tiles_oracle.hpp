// The grid of tiles of kernels/common/tiles.h, and its interpolation in double precision.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

/// Tiles that cover an image of this size.
struct TileGrid {
  explicit TileGrid(Size size);
  int count() const { return columns * rows; }
  /// Of the pixel, among those of a signal.
  int tileAt(int x, int y) const;

  int columns;
  int rows;
};

/// One value a tile, signal by signal, row by row: bilinear between the centres of tiles, constant beyond the outermost.
double betweenTiles(const Planes& values, const TileGrid& grid, int signal, int x, int y);

}  // namespace quell::tests

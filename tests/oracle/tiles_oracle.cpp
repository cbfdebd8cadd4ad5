#include "tests/oracle/tiles_oracle.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/common/tiles_params.h"

namespace quell::tests {
namespace {

int tilesAlong(int pixels) { return int(std::ceil(double(pixels) / QUELL_TILE)); }

// In units of tiles, from the centre of the first on.
double clampedPlace(int pixel, int tiles) {
  return std::clamp((pixel + 0.5) / QUELL_TILE - 0.5, 0.0, double(tiles - 1));
}

}  // namespace

TileGrid::TileGrid(Size size) : columns(tilesAlong(size.width)), rows(tilesAlong(size.height)) {}

int TileGrid::tileAt(int x, int y) const { return y / QUELL_TILE * columns + x / QUELL_TILE; }

double betweenTiles(const Planes& values, const TileGrid& grid, int signal, int x, int y) {
  const double u = clampedPlace(x, grid.columns), v = clampedPlace(y, grid.rows);
  const auto tile = [&](int column, int row) {
    const int i = std::min(row, grid.rows - 1) * grid.columns + std::min(column, grid.columns - 1);
    return double(values.values[std::size_t(signal * grid.count() + i)]);
  };
  const int column = int(u), row = int(v);
  const double right = u - column, below = v - row;
  return (1.0 - below) * ((1.0 - right) * tile(column, row) + right * tile(column + 1, row)) +
         below * ((1.0 - right) * tile(column, row + 1) + right * tile(column + 1, row + 1));
}

}  // namespace quell::tests

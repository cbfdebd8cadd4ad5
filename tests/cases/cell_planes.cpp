#include "tests/cases/cell_planes.hpp"

#include "host/core/schedule.hpp"

namespace quell::tests {
namespace {

constexpr float kMargin = 555.0f;

int elementOf(const PlaneParams& planes, int plane, int x, int y) {
  return plane * planes.stride + (y + QUELL_PLANE_MARGIN_ROWS) * planes.pitch + QUELL_PLANE_MARGIN + x;
}

}  // namespace

Planes packCells(const Planes& cells) {
  const PlaneParams planes = makePlanes(cells.size());
  Planes packed({planes.stride * cells.count, 1}, 1, kMargin);
  for (int plane = 0; plane < cells.count; ++plane)
    forEachPixel(cells.size(), [&](int x, int y) {
      packed.at(0, elementOf(planes, plane, x, y), 0) = cells.at(plane, x, y);
    });
  return packed;
}

Planes unpackCells(const Planes& packed, Size grid, int count) {
  const PlaneParams planes = makePlanes(grid);
  Planes cells(grid, count);
  for (int plane = 0; plane < count; ++plane)
    forEachPixel(
        grid, [&](int x, int y) { cells.at(plane, x, y) = packed.at(0, elementOf(planes, plane, x, y), 0); });
  return cells;
}

}  // namespace quell::tests

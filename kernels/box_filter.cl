// box_filter: sums of neighbours in a row or in a column; both, one after the other, are sums over a square window.
// Source:  He et al. 2013, section 3.4 (the box filters of their algorithm 1). Each sum is made anew: running sums would let
//          the rounding errors of bright places follow them along the row.
// In:      planes of a grid of numbers. Out: as many, of sums.
// Border:  what lies outside the grid is left out.
// Grid:    a work-item has QUELL_LANES numbers of a row of a plane.
#include "box_filter_ports.h"
#include "common/planes.h"

QUELL_INLINE floatL sumOfRow(__global const float* plane, BoxFilterParams params, int x, int y) {
  const PlaneParams grid = params.grid;
  floatL sum = ZERO_LANES;
  for (int column = x - params.radius; column <= x + params.radius; ++column) {
    // Nothing of these lanes lies in the grid, and their elements may lie beyond the margin.
    if (column + QUELL_LANES <= 0 || column >= grid.width) continue;
    const floatL value = loadLanes(plane + planeIndex(grid, column, y));
    sum += insideColumns(grid, column + LANE_INDEX) ? value : ZERO_LANES;
  }
  return sum;
}

QUELL_INLINE floatL sumOfColumn(__global const float* plane, BoxFilterParams params, int x, int y) {
  const int first = max(y - params.radius, 0);
  const int last = min(y + params.radius, params.grid.height - 1);
  floatL sum = ZERO_LANES;
  for (int row = first; row <= last; ++row) sum += loadLanes(plane + planeIndex(params.grid, x, row));
  return sum;
}

__kernel void box_filter(STAGE_ARGUMENTS(BOX_FILTER) BoxFilterParams params) {
  const PlaneParams grid = params.grid;
  const int x = (int)get_global_id(0) * QUELL_LANES;
  const int number = (int)get_global_id(1) / grid.height;
  const int y = (int)get_global_id(1) - number * grid.height;
  if (x >= grid.width || number >= params.count) return;
  __global const float* plane = boxInput + number * grid.stride;
  const floatL sum = params.alongRows ? sumOfRow(plane, params, x, y) : sumOfColumn(plane, params, x, y);
  storeLanes(sum, boxSums + number * grid.stride + planeIndex(grid, x, y));
}

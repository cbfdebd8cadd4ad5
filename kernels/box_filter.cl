// box_filter: sums of neighbours in a row or in a column, with BOX_MINIMA the least of them; both, one after the other, are
//          those of a square window.
// Source:  He et al. 2013, section 3.4 (the box filters of their algorithm 1); minima: Mara et al. 2017, stage 5. Each sum is
//          made anew: running sums would let the rounding errors of bright places follow them along the row.
// In:      planes of a grid of numbers. Out: as many, of sums or minima.
// Border:  what lies outside the grid is left out.
// Grid:    a work-item has QUELL_LANES numbers of a row of a plane.
#include "box_filter_ports.h"
#include "common/planes.h"

#if BOX_MINIMA
#define BOX_NOTHING ((floatL)(FLT_MAX))
#define BOX_JOIN(a, b) minLanes(a, b)
#else
#define BOX_NOTHING ZERO_LANES
#define BOX_JOIN(a, b) ((a) + (b))
#endif

QUELL_INLINE floatL joinRow(__global const float* plane, BoxFilterParams params, int x, int y) {
  const PlaneParams grid = params.grid;
  floatL joined = BOX_NOTHING;
  for (int column = x - params.radius; column <= x + params.radius; ++column) {
    // Nothing of these lanes lies in the grid, and their elements may lie beyond the margin.
    if (column + QUELL_LANES <= 0 || column >= grid.width) continue;
    const floatL value = loadLanes(plane + planeIndex(grid, column, y));
    joined = BOX_JOIN(joined, insideColumns(grid, column + LANE_INDEX) ? value : BOX_NOTHING);
  }
  return joined;
}

QUELL_INLINE floatL joinColumn(__global const float* plane, BoxFilterParams params, int x, int y) {
  const int first = max(y - params.radius, 0);
  const int last = min(y + params.radius, params.grid.height - 1);
  floatL joined = BOX_NOTHING;
  for (int row = first; row <= last; ++row)
    joined = BOX_JOIN(joined, loadLanes(plane + planeIndex(params.grid, x, row)));
  return joined;
}

__kernel void box_filter(STAGE_ARGUMENTS(BOX_FILTER) BoxFilterParams params) {
  const PlaneParams grid = params.grid;
  const int x = (int)get_global_id(0) * QUELL_LANES;
  const int number = (int)get_global_id(1) / grid.height;
  const int y = (int)get_global_id(1) - number * grid.height;
  if (x >= grid.width || number >= params.count) return;
  __global const float* plane = boxInput + number * grid.stride;
  const floatL joined = params.alongRows ? joinRow(plane, params, x, y) : joinColumn(plane, params, x, y);
  storeLanes(joined, boxOutput + number * grid.stride + planeIndex(grid, x, y));
}

// guided_moments: sums over cells of pixels of what the regression of a guided filter needs.
// Source:  He et al. 2013, section 3.4 and its extension to guides of several channels; the guides of Bauszat et al. 2011,
//          three channels of the normal and depth. Cells: He and Sun 2015 compute a guided filter's coefficients on a
//          smaller picture; here each of its pixels, a cell, holds the sums over all pixels that it stands for, so that
//          nothing is left out. With SUBSAMPLING 1 cells are pixels.
// In:      irradiance (3 planes per signal), guides (normals and weights), view depth; with TAP_WEIGHTS the weights of
//          pixels, instead of those of the guides.
// Out:     moments, per signal and cell the weighted sums of guided_params.h.
// Border:  pixels outside the image are left out.
// Grid:    a work-item has the cells of QUELL_LANES pixels of a row, at least one.
#include "common/surfaces.h"
#include "guided_moments_ports.h"

// Of a work-item.
#define MOMENT_CELLS (QUELL_LANES > SUBSAMPLING ? QUELL_LANES / SUBSAMPLING : 1)
#define MOMENT_WIDTH (MOMENT_CELLS * SUBSAMPLING)  // pixels
#define CELL_LANES (QUELL_LANES / MOMENT_CELLS)    // lanes that are added up for a cell
#define GUIDED_COLUMNS (QUELL_GUIDED_FEATURES + QUELL_GUIDED_CHANNELS)

#if TAP_WEIGHTS
#define MOMENT_WEIGHTS(s) (tapWeights + (s)*stride)
#else
#define MOMENT_WEIGHTS(s) (guides + (QUELL_GUIDE_WEIGHT + (s)) * stride)
#endif

// Adds the weighted products of QUELL_LANES pixels.
QUELL_INLINE void addMoments(const floatL* columns, floatL weight, floatL* sums) {
  int k = 0;
#pragma unroll
  for (int a = 0; a < QUELL_GUIDED_FEATURES; ++a) {
    const floatL weighted = weight * columns[a];
#pragma unroll
    for (int b = a; b < GUIDED_COLUMNS; ++b) sums[k++] += weighted * columns[b];
  }
}

QUELL_INLINE void storeMoments(floatL sum, __global float* cells) {
#if CELL_LANES == 1
  storeLanes(sum, cells);
#elif QUELL_LANES > 1
  const float* lanes = (const float*)&sum;
  for (int cell = 0; cell < MOMENT_CELLS; ++cell) {
    float total = 0.0f;
    for (int lane = 0; lane < CELL_LANES; ++lane) total += lanes[cell * CELL_LANES + lane];
    cells[cell] = total;
  }
#endif
}

__kernel void guided_moments(STAGE_ARGUMENTS(GUIDED_MOMENTS) GuidedParams params) {
  const PlaneParams planes = params.planes;
  const PlaneParams cells = params.cells;
  const int stride = planes.stride;
  const int cellX = (int)get_global_id(0) * MOMENT_CELLS;
  const int cellY = (int)get_global_id(1);
  if (cellX >= cells.width || cellY >= cells.height) return;
  const int left = cellX * SUBSAMPLING;
  const int top = cellY * SUBSAMPLING;
  const int rows = min(SUBSAMPLING, planes.height - top);
  const int empty = SKIP && !anySurface(surfaces, planes, left, top, left + MOMENT_WIDTH - 1, top + rows - 1);
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    floatL sums[QUELL_GUIDED_SUMS];
    UNROLL_ON_GPU
    for (int k = 0; k < QUELL_GUIDED_SUMS; ++k) sums[k] = ZERO_LANES;
    for (int row = 0; !empty && row < rows; ++row) {
      for (int x = left; x < left + MOMENT_WIDTH && x < planes.width; x += QUELL_LANES) {
        const int index = planeIndex(planes, x, top + row);
        const floatL weight = loadLanes(MOMENT_WEIGHTS(s) + index);
        const intL counts = insideColumns(planes, x + LANE_INDEX) && weight > 0.0f;
        const float3L normal = loadLanes3(guides + QUELL_GUIDE_NORMAL * stride, index, stride);
        const float3L color = loadLanes3(irradiance + 3 * s * stride, index, stride);
        const floatL depth =
            clampLanes(loadLanes(viewDepth + index), -QUELL_GUIDED_MOST_DEPTH, QUELL_GUIDED_MOST_DEPTH);
        const floatL columns[GUIDED_COLUMNS] = {ONE_LANES, normal.x, normal.y, normal.z,
                                                depth,     color.x,  color.y,  color.z};
        addMoments(columns, counts ? weight : ZERO_LANES, sums);
      }
    }
    UNROLL_ON_GPU
    for (int k = 0; k < QUELL_GUIDED_SUMS; ++k)
      storeMoments(sums[k],
                   moments + (s * QUELL_GUIDED_SUMS + k) * cells.stride + planeIndex(cells, cellX, cellY));
  }
}

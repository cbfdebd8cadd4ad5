// guided_evaluate: what the mean coefficients of the windows around a pixel make of its guides.
// Source:  He et al. 2013, eq. (8) and (10): mean a times guide + mean b; between cells coefficients are interpolated
//          bilinearly (He and Sun 2015, algorithm 2).
// In:      windowCoefficients: coefficients of guided_solve, summed over the windows that a cell lies in; guides (normals)
//          and view depth of this frame.
// Out:     guidedIrradiance (3 planes per signal), >= 0; 0 in background and where no window had a sample.
// Border:  cells outside the grid are left out.
#include "common/surfaces.h"
#include "guided_evaluate_ports.h"

// The four cells around QUELL_LANES pixels: elements of the first lane's, and weights.
typedef struct CellTaps {
  int index[4];
  floatL weight[4];
} CellTaps;

#if SUBSAMPLING == 1
#define TAPS 1

QUELL_INLINE CellTaps findTaps(PlaneParams cells, int x, int y) {
  CellTaps taps;
  taps.index[0] = planeIndex(cells, x, y);
  taps.weight[0] = ONE_LANES;
  return taps;
}

#define SPREAD(v) (v)
#else
#define TAPS 4
#define HALF_CELL (SUBSAMPLING / 2)

// Lanes of pixels from lanes of cells.
#if QUELL_LANES == 1
#define SPREAD(v) (v)
#elif QUELL_LANES == 4 && SUBSAMPLING == 2
#define SPREAD(v) (v).s0112
#elif QUELL_LANES == 4 && SUBSAMPLING == 4
#define SPREAD(v) (v).s0011
#elif QUELL_LANES == 4 && SUBSAMPLING == 8
#define SPREAD(v) (v).s0000
#elif QUELL_LANES == 8 && SUBSAMPLING == 2
#define SPREAD(v) (v).s01122334
#elif QUELL_LANES == 8 && SUBSAMPLING == 4
#define SPREAD(v) (v).s00111122
#elif QUELL_LANES == 8 && SUBSAMPLING == 8
#define SPREAD(v) (v).s00001111
#elif QUELL_LANES == 16 && SUBSAMPLING == 2
#define SPREAD(v) (v).s0112233445566778
#elif QUELL_LANES == 16 && SUBSAMPLING == 4
#define SPREAD(v) (v).s0011112222333344
#elif QUELL_LANES == 16 && SUBSAMPLING == 8
#define SPREAD(v) (v).s0000111111112222
#endif

// Work-items begin at multiples of QUELL_LANES, so that a lane's cell is always the same step away from the first one's.
QUELL_INLINE CellTaps findTaps(PlaneParams cells, int x, int y) {
  const int cellX = (x + HALF_CELL) / SUBSAMPLING - 1;
  const int cellY = (y + HALF_CELL) / SUBSAMPLING - 1;
  const intL column = x + HALF_CELL + LANE_INDEX;
  const intL cell = column / SUBSAMPLING - 1;
  const floatL right = (TO_FLOAT(column % SUBSAMPLING) + 0.5f) * (1.0f / SUBSAMPLING);
  const float below = ((float)((y + HALF_CELL) % SUBSAMPLING) + 0.5f) * (1.0f / SUBSAMPLING);
  CellTaps taps;
  UNROLL_ON_GPU
  for (int tap = 0; tap < TAPS; ++tap) {
    const int dx = tap & 1;
    const int dy = tap >> 1;
    const int row = cellY + dy;
    const float vertical = row < 0 || row >= cells.height ? 0.0f : dy ? below : 1.0f - below;
    const floatL horizontal = dx ? right : 1.0f - right;
    taps.index[tap] = planeIndex(cells, cellX + dx, clamp(row, 0, cells.height - 1));
    taps.weight[tap] = insideColumns(cells, cell + dx) ? vertical * horizontal : ZERO_LANES;
  }
  return taps;
}
#endif

QUELL_INLINE floatL coefficientAt(__global const float* plane, CellTaps taps) {
  floatL sum = ZERO_LANES;
  UNROLL_ON_GPU
  for (int tap = 0; tap < TAPS; ++tap) {
    const floatL value = loadLanes(plane + taps.index[tap]);
    // What lies outside the grid may be any number.
    sum += taps.weight[tap] > 0.0f ? taps.weight[tap] * SPREAD(value) : ZERO_LANES;
  }
  return sum;
}

__kernel void guided_evaluate(STAGE_ARGUMENTS(GUIDED_EVALUATE) GuidedParams params) {
  BEGIN_PIXELS(params.planes);
  LEAVE_OUT_BACKGROUND(NOTHING_ELSE)
  const int cellStride = params.cells.stride;
  const CellTaps taps = findTaps(params.cells, x, y);
  const float3L normal = loadLanes3(guides + QUELL_GUIDE_NORMAL * stride, index, stride);
  const floatL depth =
      clampLanes(loadLanes(viewDepth + index), -QUELL_GUIDED_MOST_DEPTH, QUELL_GUIDED_MOST_DEPTH);
  const intL surface = dot3(normal, normal) > 0.0f;
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    __global const float* signal = windowCoefficients + s * QUELL_GUIDED_COEFFICIENTS * cellStride;
    const floatL used = coefficientAt(signal + QUELL_GUIDED_USED * cellStride, taps);
    const intL known = surface && used > 0.0f;
    const floatL inverse = 1.0f / (used > 0.0f ? used : ONE_LANES);
    for (int c = 0; c < QUELL_GUIDED_CHANNELS; ++c) {
      const floatL guide[QUELL_GUIDED_FEATURES] = {ONE_LANES, normal.x, normal.y, normal.z, depth};
      floatL sum = ZERO_LANES;
      UNROLL_ON_GPU
      for (int j = 0; j < QUELL_GUIDED_FEATURES; ++j)
        sum += guide[j] * coefficientAt(signal + (j * QUELL_GUIDED_CHANNELS + c) * cellStride, taps);
      const floatL value = clampLanes(sum * inverse, 0.0f, QUELL_MAX_RADIANCE);
      storeLanes(known ? value : ZERO_LANES, guidedIrradiance + (3 * s + c) * stride + index);
    }
  }
}

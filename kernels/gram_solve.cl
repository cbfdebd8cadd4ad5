// gram_solve: from the sums of tiles to the coefficients of a fit, one window a lane.
// Paper:   Koskela et al. 2019, eq. (2), by normal equations instead of a factorisation of the pixels.
// In:      tile buffer of gram_sums. Out: one record a window, as fit.cl writes it.
// Windows: GRAM_OVERLAP 0: a window is a tile. 1: the tile and its eight neighbours, weighted with a tent
//          (1/4, 1/2, 1) per axis; their sums are first taken to the scaling of the window, exactly: with
//          w' = r w + t per axis, w'^2 = r^2 w^2 + 2 r t w + t^2, the Gram matrix G becomes M G M^T. What powers and
//          products need for that but the fit does not use stands behind its features in the sums.
// Noise, solve: see normal_equations.h.
#include "common/blocks.h"
#include "common/lanes.h"
#include "gram_solve_ports.h"
#include "normal_equations.h"

// Of one lane.
#define TILE_VALUE(i) row[tile.s##i]

QUELL_INLINE floatL tileValue(__global const float* tiles, int tileStride, int plane, intL tile) {
#if QUELL_LANES == 1
  return tiles[plane * tileStride + tile];
#else
  __global const float* row = tiles + plane * tileStride;
  return (floatL)(EACH_LANE(TILE_VALUE));
#endif
}

// Range and scaling of the unbounded variables.
typedef struct Range {
  floatL low[QUELL_SCALED_SLOTS];
  floatL high[QUELL_SCALED_SLOTS];
  floatL anchor[QUELL_SCALED_SLOTS];
  floatL scale[QUELL_SCALED_SLOTS];
} Range;

QUELL_INLINE void loadRange(__global const float* tiles, int tileStride, intL tile, Range* range) {
  UNROLL_ON_GPU
  for (int k = 0; k < QUELL_SCALED; ++k) {
    range->low[k] = tileValue(tiles, tileStride, QUELL_GRAM_LOW + k, tile);
    range->high[k] = tileValue(tiles, tileStride, QUELL_GRAM_HIGH + k, tile);
  }
  scaleRangesLanes(range->low, range->high, range->anchor, range->scale);
}

#if GRAM_OVERLAP
#define NEIGHBOURS 9

// G becomes M G M^T for the change of scaling of one variable v. The host lists, for each, the features that contain
// it, highest power first: RESCALE_n(i, i_n-1, .., i_0) replaces feature i, with power n of v, by a combination of
// itself and of the features i_m with the power lowered to m. First for columns, then for rows.
#define VARIABLE(v, steps)                                                   \
  {                                                                          \
    const floatL r = window->scale[v] / own.scale[v];                        \
    const floatL t = (own.anchor[v] - window->anchor[v]) * window->scale[v]; \
    UNROLL_ON_GPU                                                            \
    for (int k = 0; k < QUELL_GRAM_COLUMNS; ++k) {                           \
      floatL* line = g[k];                                                   \
      const int stride = 1;                                                  \
      steps                                                                  \
    }                                                                        \
    UNROLL_ON_GPU                                                            \
    for (int k = 0; k < QUELL_GRAM_COLUMNS; ++k) {                           \
      floatL* line = &g[0][k];                                               \
      const int stride = QUELL_GRAM_COLUMNS;                                 \
      steps                                                                  \
    }                                                                        \
  }
#define AT(i) line[(i)*stride]
#define RESCALE_1(i, i0) AT(i) = r * AT(i) + t * AT(i0);
#define RESCALE_2(i, i1, i0) AT(i) = r * r * AT(i) + (2.0f * r * t) * AT(i1) + t * t * AT(i0);
#define RESCALE_3(i, i2, i1, i0) \
  AT(i) = r * r * r * AT(i) + 3.0f * (r * r * t * AT(i2) + r * t * t * AT(i1)) + t * t * t * AT(i0);
#ifndef QUELL_RESCALE_LIST
#if QUELL_GRAM_FEATURES == 10 && QUELL_SCALED == 3
#define QUELL_RESCALE_LIST                        \
  VARIABLE(0, RESCALE_2(7, 4, 0) RESCALE_1(4, 0)) \
  VARIABLE(1, RESCALE_2(8, 5, 0) RESCALE_1(5, 0)) VARIABLE(2, RESCALE_2(9, 6, 0) RESCALE_1(6, 0))
#else
#define QUELL_RESCALE_LIST
#endif
#endif
#endif

#if GRAM_OVERLAP
typedef struct Neighbour {
  intL tile;  // some tile where it lies outside
  intL inside;
} Neighbour;

QUELL_INLINE Neighbour neighbourOf(GramParams params, intL tileX, intL tileY, int n) {
  const intL x = tileX + (n % 3 - 1);
  const intL y = tileY + (n / 3 - 1);
  Neighbour neighbour;
  neighbour.inside = x >= 0 && x < params.tilesX && y >= 0 && y < params.tilesY;
  neighbour.tile = neighbour.inside ? y * params.tilesX + x : (intL)(0);
  return neighbour;
}
#endif

#if GRAM_OVERLAP
// Range over the tiles of a window and the scaling that follows from it.
QUELL_INLINE void findWindowRange(__global const float* tiles, GramParams params, intL tileX, intL tileY,
                                  Range* window) {
  UNROLL_ON_GPU
  for (int k = 0; k < QUELL_SCALED; ++k) {
    window->low[k] = (floatL)(NO_POSITION);
    window->high[k] = (floatL)(-NO_POSITION);
  }
#pragma unroll 1
  for (int n = 0; n < NEIGHBOURS; ++n) {
    const Neighbour neighbour = neighbourOf(params, tileX, tileY, n);
    Range own;
    loadRange(tiles, params.tileStride, neighbour.tile, &own);
    UNROLL_ON_GPU
    for (int k = 0; k < QUELL_SCALED; ++k) {
      window->low[k] = neighbour.inside ? minLanes(window->low[k], own.low[k]) : window->low[k];
      window->high[k] = neighbour.inside ? maxLanes(window->high[k], own.high[k]) : window->high[k];
    }
  }
  scaleRangesLanes(window->low, window->high, window->anchor, window->scale);
}

// Adds the sums of a tile, in the scaling of the window.
QUELL_INLINE void addNeighbour(__global const float* tiles, GramParams params, Neighbour neighbour,
                               float tent, const Range* window, floatL* sums) {
  floatL g[QUELL_GRAM_COLUMNS][QUELL_GRAM_COLUMNS];
  UNROLL_ON_GPU
  for (int a = 0; a < QUELL_GRAM_COLUMNS; ++a) {
    UNROLL_ON_GPU
    for (int b = a; b < QUELL_GRAM_COLUMNS; ++b) {
      g[a][b] = tileValue(tiles, params.tileStride, QUELL_GRAM_INDEX(a, b), neighbour.tile);
      g[b][a] = g[a][b];
    }
  }
  Range own;  // loaded again: nine of them would not fit into a GPU's registers
  loadRange(tiles, params.tileStride, neighbour.tile, &own);
  QUELL_RESCALE_LIST
  const intL counts = neighbour.inside && g[0][0] > 0.0f;
  UNROLL_ON_GPU
  for (int a = 0; a < QUELL_GRAM_COLUMNS; ++a) {
    UNROLL_ON_GPU
    for (int b = a; b < QUELL_GRAM_COLUMNS; ++b)
      sums[QUELL_GRAM_INDEX(a, b)] += counts ? tent * g[a][b] : ZERO_LANES;
  }
}
#endif

// The window's sums in its own scaling; out-of-grid neighbours are left out.
QUELL_INLINE void gatherWindow(__global const float* tiles, GramParams params, intL tileX, intL tileY,
                               Range* window, floatL* sums) {
#if GRAM_OVERLAP
  findWindowRange(tiles, params, tileX, tileY, window);
  UNROLL_ON_GPU
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) sums[k] = ZERO_LANES;
#pragma unroll 1
  for (int n = 0; n < NEIGHBOURS; ++n) {
    const float tent = (n % 3 == 1 ? 1.0f : 0.5f) * (n / 3 == 1 ? 1.0f : 0.5f);
    addNeighbour(tiles, params, neighbourOf(params, tileX, tileY, n), tent, window, sums);
  }
#else
  const intL tile = tileY * params.tilesX + tileX;
  loadRange(tiles, params.tileStride, tile, window);
  UNROLL_ON_GPU
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) sums[k] = tileValue(tiles, params.tileStride, k, tile);
#endif
}

QUELL_INLINE void storeLane(__global float* record, int element, floatL value, int lane) {
  record[element] = ((const float*)&value)[lane];
}

__kernel void gram_solve(STAGE_ARGUMENTS(GRAM_SOLVE) GramParams params) {
  const int first = (int)get_global_id(0) * QUELL_LANES;
  const int count = params.tilesX * params.tilesY;
  if (first >= count) return;
  const intL window = minLanesInt(first + LANE_INDEX, (intL)(count - 1));
  const intL tileY = window / params.tilesX;
  const intL tileX = window - tileY * params.tilesX;

  Range range;
  floatL sums[QUELL_GRAM_SUMS];
  gatherWindow(gramTiles, params, tileX, tileY, &range, sums);
  floatL coefficients[QUELL_FEATURES][QUELL_FIT_CHANNELS];
  solveWindow(sums, params.noiseVariance, coefficients);

  const intL hasSamples = sums[QUELL_GRAM_INDEX(0, 0)] > 0.0f;
  for (int lane = 0; lane < min(QUELL_LANES, count - first); ++lane) {
    __global float* record = fitRecords + (first + lane) * QUELL_FIT_RECORD;
    UNROLL_ON_GPU
    for (int j = 0; j < QUELL_FEATURES; ++j) UNROLL_ON_GPU
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      storeLane(record, j * QUELL_FIT_CHANNELS + c, coefficients[j][c], lane);
    storeLane(record, QUELL_FIT_USABLE, hasSamples ? ONE_LANES : ZERO_LANES, lane);
    UNROLL_ON_GPU
    for (int k = 0; k < QUELL_SCALED; ++k) {
      storeLane(record, QUELL_FIT_ANCHOR + k, range.anchor[k], lane);
      storeLane(record, QUELL_FIT_SCALE + k, range.scale[k], lane);
    }
  }
}

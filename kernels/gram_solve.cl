// gram_solve: from the sums of tiles to the coefficients of a fit, one window a lane.
// Paper:   Koskela et al. 2019, eq. (2), by normal equations instead of a factorisation of the pixels.
// In:      tile buffer of gram_sums. Out: one record a window, as fit.cl writes it.
// Windows: GRAM_OVERLAP 0: a window is a tile. 1: the tile and its eight neighbours, weighted with a tent
//          (1/4, 1/2, 1) per axis; their sums are first taken to the scaling of the window, exactly: with
//          w' = r w + t per axis, w'^2 = r^2 w^2 + 2 r t w + t^2, the Gram matrix G becomes M G M^T. What powers and
//          products need for that but the fit does not use stands behind its features in the sums.
// Noise:   independent zero-mean noise of variance s^2 on every feature but the constant one adds W s^2 to the
//          diagonal of the expected Gram matrix (W: sum of weights). It is added in the scaled space in which the
//          stochastic regularisation adds its noise: deterministic, and the same in expectation.
// Solve:   the constant is removed by centring, features are normalised to unit variance, constant ones and
//          combinations of others are dropped, then Cholesky. Windows with too few pixels get their mean.
#include "common/blocks.h"
#include "common/lanes.h"
#include "gram_params.h"

// Features without the constant one.
#define VARIED (QUELL_FEATURES - 1)
#define VARIED_ROOM (VARIED > 0 ? VARIED : 1)  // arrays must not be empty
// Element of the lower triangle of the normal matrix for row >= column.
#define LOWER(row, column) ((row) * ((row) + 1) / 2 + (column))

QUELL_INLINE floatL tileValue(__global const float* tiles, int tileStride, int plane, intL tile) {
#if QUELL_LANES == 1
  return tiles[plane * tileStride + tile];
#else
  __global const float* row = tiles + plane * tileStride;
  return (float16)(row[tile.s0], row[tile.s1], row[tile.s2], row[tile.s3], row[tile.s4], row[tile.s5],
                   row[tile.s6], row[tile.s7], row[tile.s8], row[tile.s9], row[tile.sa], row[tile.sb],
                   row[tile.sc], row[tile.sd], row[tile.se], row[tile.sf]);
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

// The window's sums in its own scaling; out-of-grid neighbours are left out.
QUELL_INLINE void gatherWindow(__global const float* tiles, GramParams params, intL tileX, intL tileY,
                               Range* window, floatL* sums) {
#if GRAM_OVERLAP
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
  UNROLL_ON_GPU
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) sums[k] = ZERO_LANES;
#pragma unroll 1
  for (int n = 0; n < NEIGHBOURS; ++n) {
    const Neighbour neighbour = neighbourOf(params, tileX, tileY, n);
    const float tent = (n % 3 == 1 ? 1.0f : 0.5f) * (n / 3 == 1 ? 1.0f : 0.5f);
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
#else
  const intL tile = tileY * params.tilesX + tileX;
  loadRange(tiles, params.tileStride, tile, window);
  UNROLL_ON_GPU
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) sums[k] = tileValue(tiles, params.tileStride, k, tile);
#endif
}

// Coefficients of all features for every channel, from the window's sums.
QUELL_INLINE void solveWindow(const floatL* sums, float noiseVariance,
                              floatL coefficients[QUELL_FEATURES][QUELL_FIT_CHANNELS]) {
  const floatL weight = sums[QUELL_GRAM_INDEX(0, 0)];
  const floatL inverseWeight = 1.0f / (weight > 0.0f ? weight : ONE_LANES);
  floatL mean[QUELL_GRAM_COLUMNS];
  UNROLL_ON_GPU
  for (int k = 1; k < QUELL_GRAM_COLUMNS; ++k) mean[k] = sums[QUELL_GRAM_INDEX(0, k)] * inverseWeight;

  // Centred, regularised and normalised: the diagonal becomes 1, or the feature is dropped (0).
  floatL inverseDeviation[VARIED_ROOM];
  UNROLL_ON_GPU
  for (int j = 0; j < VARIED; ++j) {
    const floatL square = sums[QUELL_GRAM_INDEX(j + 1, j + 1)];
    const floatL variance = square - sums[QUELL_GRAM_INDEX(0, j + 1)] * mean[j + 1];
    const intL usable =
        weight >= QUELL_GRAM_LEAST_WEIGHT && variance > QUELL_GRAM_VARIANCE_TOLERANCE * square;
    const floatL counted = usable ? variance : ZERO_LANES;
    const floatL regularised = counted + weight * noiseVariance;
    inverseDeviation[j] = counted > 0.0f ? 1.0f / SQRT(counted > 0.0f ? regularised : ONE_LANES) : ZERO_LANES;
  }
  floatL factor[LOWER(VARIED_ROOM, 0)];
  floatL right[VARIED_ROOM][QUELL_FIT_CHANNELS];
  UNROLL_ON_GPU
  for (int i = 0; i < VARIED; ++i) {
    UNROLL_ON_GPU
    for (int j = 0; j < i; ++j) {
      const floatL covariance =
          sums[QUELL_GRAM_INDEX(j + 1, i + 1)] - sums[QUELL_GRAM_INDEX(0, i + 1)] * mean[j + 1];
      factor[LOWER(i, j)] = covariance * inverseDeviation[i] * inverseDeviation[j];
    }
    factor[LOWER(i, i)] = inverseDeviation[i] > 0.0f ? ONE_LANES : ZERO_LANES;
    UNROLL_ON_GPU
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c) {
      const int column = QUELL_GRAM_FEATURES + c;
      right[i][c] =
          (sums[QUELL_GRAM_INDEX(i + 1, column)] - sums[QUELL_GRAM_INDEX(0, i + 1)] * mean[column]) *
          inverseDeviation[i];
    }
  }

  // Cholesky; the diagonal keeps the inverse of the factor's, 0 for a dropped feature.
  UNROLL_ON_GPU
  for (int j = 0; j < VARIED; ++j) {
    floatL pivot = factor[LOWER(j, j)];
    UNROLL_ON_GPU
    for (int k = 0; k < j; ++k) pivot -= factor[LOWER(j, k)] * factor[LOWER(j, k)];
    const intL keep = pivot > QUELL_GRAM_PIVOT_TOLERANCE;
    const floatL inverse = keep ? 1.0f / SQRT(keep ? pivot : ONE_LANES) : ZERO_LANES;
    factor[LOWER(j, j)] = inverse;
    UNROLL_ON_GPU
    for (int i = j + 1; i < VARIED; ++i) {
      floatL sum = factor[LOWER(i, j)];
      UNROLL_ON_GPU
      for (int k = 0; k < j; ++k) sum -= factor[LOWER(i, k)] * factor[LOWER(j, k)];
      factor[LOWER(i, j)] = sum * inverse;
    }
  }

  UNROLL_ON_GPU
  for (int c = 0; c < QUELL_FIT_CHANNELS; ++c) {
    floatL solution[VARIED_ROOM];
    UNROLL_ON_GPU
    for (int i = 0; i < VARIED; ++i) {
      floatL sum = right[i][c];
      UNROLL_ON_GPU
      for (int k = 0; k < i; ++k) sum -= factor[LOWER(i, k)] * solution[k];
      solution[i] = sum * factor[LOWER(i, i)];
    }
    UNROLL_ON_GPU
    for (int i = VARIED - 1; i >= 0; --i) {
      floatL sum = solution[i];
      UNROLL_ON_GPU
      for (int k = i + 1; k < VARIED; ++k) sum -= factor[LOWER(k, i)] * solution[k];
      solution[i] = sum * factor[LOWER(i, i)];
    }
    floatL intercept = mean[QUELL_GRAM_FEATURES + c];
    UNROLL_ON_GPU
    for (int i = 0; i < VARIED; ++i) {
      coefficients[i + 1][c] = solution[i] * inverseDeviation[i];
      intercept -= coefficients[i + 1][c] * mean[i + 1];
    }
    coefficients[0][c] = intercept;
  }
}

QUELL_INLINE void storeLane(__global float* record, int element, floatL value, int lane) {
  record[element] = ((const float*)&value)[lane];
}

__kernel void gram_solve(__global const float* tiles, __global float* records, GramParams params) {
  const int first = (int)get_global_id(0) * QUELL_LANES;
  const int count = params.tilesX * params.tilesY;
  if (first >= count) return;
  const intL window = minLanesInt(first + LANE_INDEX, (intL)(count - 1));
  const intL tileY = window / params.tilesX;
  const intL tileX = window - tileY * params.tilesX;

  Range range;
  floatL sums[QUELL_GRAM_SUMS];
  gatherWindow(tiles, params, tileX, tileY, &range, sums);
  floatL coefficients[QUELL_FEATURES][QUELL_FIT_CHANNELS];
  solveWindow(sums, params.noiseVariance, coefficients);

  const intL hasSamples = sums[QUELL_GRAM_INDEX(0, 0)] > 0.0f;
  for (int lane = 0; lane < min(QUELL_LANES, count - first); ++lane) {
    __global float* record = records + (first + lane) * QUELL_FIT_RECORD;
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

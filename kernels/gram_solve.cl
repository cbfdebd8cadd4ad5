// gram_solve: from the sums of tiles to the coefficients of a fit, one window a lane.
// Paper:   Koskela et al. 2019, eq. (2), by normal equations instead of a factorisation of the pixels.
// In:      tile buffer of gram_sums. Out: one record a window, as fit.cl writes it; scale 0 where no pixel had a sample.
// Windows: GRAM_OVERLAP 0: a window is a tile. 1: the tile and its eight neighbours, weighted with a tent
//          (1/4, 1/2, 1) per axis; their sums are first taken to the scaling of the window, exactly: with
//          w' = r w + t per axis, w'^2 = r^2 w^2 + 2 r t w + t^2, the Gram matrix G becomes M G M^T.
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

typedef struct Window {
  floatL low[3];
  floatL high[3];
  floatL anchor[3];
  floatL scale[3];
} Window;

#if GRAM_OVERLAP
// Features 4..6 are positions, 7..9 their squares: G becomes M G M^T for the change of scaling of one axis. The two
// columns are replaced by combinations of themselves and of the constant column, first as columns, then as rows.
QUELL_INLINE void changeScaling(floatL g[QUELL_FIT_COLUMNS][QUELL_FIT_COLUMNS], int axis, floatL r,
                                floatL t) {
  const int p = 4 + axis;
  const int q = 7 + axis;
  const floatL rt = 2.0f * r * t;
  for (int k = 0; k < QUELL_FIT_COLUMNS; ++k) {
    const floatL one = g[k][0];
    const floatL linear = g[k][p];
    g[k][p] = r * linear + t * one;
    g[k][q] = r * r * g[k][q] + rt * linear + t * t * one;
  }
  for (int k = 0; k < QUELL_FIT_COLUMNS; ++k) {
    const floatL one = g[0][k];
    const floatL linear = g[p][k];
    g[p][k] = r * linear + t * one;
    g[q][k] = r * r * g[q][k] + rt * linear + t * t * one;
  }
}
#endif

// The window's sums in its own scaling; out-of-grid neighbours are left out.
QUELL_INLINE void gatherWindow(__global const float* tiles, GramParams params, intL tileX, intL tileY,
                               Window* window, floatL* sums) {
#if GRAM_OVERLAP
  for (int axis = 0; axis < 3; ++axis) {
    window->low[axis] = (floatL)(NO_POSITION);
    window->high[axis] = (floatL)(-NO_POSITION);
  }
  for (int n = 0; n < 9; ++n) {
    const intL x = tileX + (n % 3 - 1);
    const intL y = tileY + (n / 3 - 1);
    const intL inside = x >= 0 && x < params.tilesX && y >= 0 && y < params.tilesY;
    const intL tile = inside ? y * params.tilesX + x : (intL)(0);
    for (int axis = 0; axis < 3; ++axis) {
      const floatL low = tileValue(tiles, params.tileStride, QUELL_GRAM_LOW + axis, tile);
      const floatL high = tileValue(tiles, params.tileStride, QUELL_GRAM_HIGH + axis, tile);
      window->low[axis] = inside ? minLanes(window->low[axis], low) : window->low[axis];
      window->high[axis] = inside ? maxLanes(window->high[axis], high) : window->high[axis];
    }
  }
  scalePositionsLanes(window->low, window->high, window->anchor, window->scale);
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) sums[k] = ZERO_LANES;
  for (int n = 0; n < 9; ++n) {
    const intL x = tileX + (n % 3 - 1);
    const intL y = tileY + (n / 3 - 1);
    const intL inside = x >= 0 && x < params.tilesX && y >= 0 && y < params.tilesY;
    const intL tile = inside ? y * params.tilesX + x : (intL)(0);
    const float tent = (n % 3 == 1 ? 1.0f : 0.5f) * (n / 3 == 1 ? 1.0f : 0.5f);
    floatL g[QUELL_FIT_COLUMNS][QUELL_FIT_COLUMNS];
    for (int a = 0; a < QUELL_FIT_COLUMNS; ++a) {
      for (int b = a; b < QUELL_FIT_COLUMNS; ++b) {
        g[a][b] = tileValue(tiles, params.tileStride, QUELL_GRAM_INDEX(a, b), tile);
        g[b][a] = g[a][b];
      }
    }
    floatL low[3], high[3], anchor[3], scale[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = tileValue(tiles, params.tileStride, QUELL_GRAM_LOW + axis, tile);
      high[axis] = tileValue(tiles, params.tileStride, QUELL_GRAM_HIGH + axis, tile);
    }
    scalePositionsLanes(low, high, anchor, scale);
    for (int axis = 0; axis < 3; ++axis) {
      const floatL ratio = window->scale[axis] / scale[axis];
      changeScaling(g, axis, ratio, (anchor[axis] - window->anchor[axis]) * window->scale[axis]);
    }
    const intL counts = inside && low[0] <= high[0];
    for (int a = 0; a < QUELL_FIT_COLUMNS; ++a) {
      for (int b = a; b < QUELL_FIT_COLUMNS; ++b)
        sums[QUELL_GRAM_INDEX(a, b)] += counts ? tent * g[a][b] : ZERO_LANES;
    }
  }
#else
  const intL tile = tileY * params.tilesX + tileX;
  for (int axis = 0; axis < 3; ++axis) {
    window->low[axis] = tileValue(tiles, params.tileStride, QUELL_GRAM_LOW + axis, tile);
    window->high[axis] = tileValue(tiles, params.tileStride, QUELL_GRAM_HIGH + axis, tile);
  }
  scalePositionsLanes(window->low, window->high, window->anchor, window->scale);
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) sums[k] = tileValue(tiles, params.tileStride, k, tile);
#endif
}

// Coefficients of all features for every channel, from the window's sums.
QUELL_INLINE void solveWindow(const floatL* sums, float noiseVariance,
                              floatL coefficients[QUELL_FEATURES][QUELL_FIT_CHANNELS]) {
  const floatL weight = sums[QUELL_GRAM_INDEX(0, 0)];
  const floatL inverseWeight = 1.0f / (weight > 0.0f ? weight : ONE_LANES);
  floatL mean[QUELL_FIT_COLUMNS];
  for (int k = 1; k < QUELL_FIT_COLUMNS; ++k) mean[k] = sums[QUELL_GRAM_INDEX(0, k)] * inverseWeight;

  // Centred, regularised and normalised: the diagonal becomes 1, or the feature is dropped (0).
  floatL inverseDeviation[VARIED];
  for (int j = 0; j < VARIED; ++j) {
    const floatL square = sums[QUELL_GRAM_INDEX(j + 1, j + 1)];
    const floatL variance = square - sums[QUELL_GRAM_INDEX(0, j + 1)] * mean[j + 1];
    const intL usable =
        weight >= QUELL_GRAM_LEAST_WEIGHT && variance > QUELL_GRAM_VARIANCE_TOLERANCE * square;
    const floatL counted = usable ? variance : ZERO_LANES;
    const floatL regularised = counted + weight * noiseVariance;
    inverseDeviation[j] = counted > 0.0f ? 1.0f / SQRT(counted > 0.0f ? regularised : ONE_LANES) : ZERO_LANES;
  }
  floatL factor[LOWER(VARIED, 0)];
  floatL right[VARIED][QUELL_FIT_CHANNELS];
  for (int i = 0; i < VARIED; ++i) {
    for (int j = 0; j < i; ++j) {
      const floatL covariance =
          sums[QUELL_GRAM_INDEX(j + 1, i + 1)] - sums[QUELL_GRAM_INDEX(0, i + 1)] * mean[j + 1];
      factor[LOWER(i, j)] = covariance * inverseDeviation[i] * inverseDeviation[j];
    }
    factor[LOWER(i, i)] = inverseDeviation[i] > 0.0f ? ONE_LANES : ZERO_LANES;
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c) {
      const int column = QUELL_FEATURES + c;
      right[i][c] =
          (sums[QUELL_GRAM_INDEX(i + 1, column)] - sums[QUELL_GRAM_INDEX(0, i + 1)] * mean[column]) *
          inverseDeviation[i];
    }
  }

  // Cholesky; the diagonal keeps the inverse of the factor's, 0 for a dropped feature.
  for (int j = 0; j < VARIED; ++j) {
    floatL pivot = factor[LOWER(j, j)];
    for (int k = 0; k < j; ++k) pivot -= factor[LOWER(j, k)] * factor[LOWER(j, k)];
    const intL keep = pivot > QUELL_GRAM_PIVOT_TOLERANCE;
    const floatL inverse = keep ? 1.0f / SQRT(keep ? pivot : ONE_LANES) : ZERO_LANES;
    factor[LOWER(j, j)] = inverse;
    for (int i = j + 1; i < VARIED; ++i) {
      floatL sum = factor[LOWER(i, j)];
      for (int k = 0; k < j; ++k) sum -= factor[LOWER(i, k)] * factor[LOWER(j, k)];
      factor[LOWER(i, j)] = sum * inverse;
    }
  }

  for (int c = 0; c < QUELL_FIT_CHANNELS; ++c) {
    floatL solution[VARIED];
    for (int i = 0; i < VARIED; ++i) {
      floatL sum = right[i][c];
      for (int k = 0; k < i; ++k) sum -= factor[LOWER(i, k)] * solution[k];
      solution[i] = sum * factor[LOWER(i, i)];
    }
    for (int i = VARIED - 1; i >= 0; --i) {
      floatL sum = solution[i];
      for (int k = i + 1; k < VARIED; ++k) sum -= factor[LOWER(k, i)] * solution[k];
      solution[i] = sum * factor[LOWER(i, i)];
    }
    floatL intercept = mean[QUELL_FEATURES + c];
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

  Window range;
  floatL sums[QUELL_GRAM_SUMS];
  gatherWindow(tiles, params, tileX, tileY, &range, sums);
  floatL coefficients[QUELL_FEATURES][QUELL_FIT_CHANNELS];
  solveWindow(sums, params.noiseVariance, coefficients);

  const intL hasSamples = sums[QUELL_GRAM_INDEX(0, 0)] > 0.0f;
  for (int lane = 0; lane < min(QUELL_LANES, count - first); ++lane) {
    __global float* record = records + (first + lane) * QUELL_FIT_RECORD;
    for (int j = 0; j < QUELL_FEATURES; ++j)
      for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
        storeLane(record, j * QUELL_FIT_CHANNELS + c, coefficients[j][c], lane);
    for (int axis = 0; axis < 3; ++axis) {
      storeLane(record, QUELL_FIT_ANCHOR + axis, range.anchor[axis], lane);
      storeLane(record, QUELL_FIT_SCALE + axis, hasSamples ? range.scale[axis] : ZERO_LANES, lane);
    }
  }
}

// The fit of a window by normal equations, from its sums (gram_params.h); a window a lane.
// Noise: independent zero-mean noise of variance s^2 on every feature but the constant one adds W s^2 to the
//        diagonal of the expected Gram matrix (W: sum of weights). It is added in the scaled space in which the
//        stochastic regularisation adds its noise: deterministic, and the same in expectation.
// Solve: the constant is removed by centring, features are normalised to unit variance, constant ones and
//        combinations of others are dropped, then Cholesky. Windows with too few pixels get their mean.
#ifndef QUELL_NORMAL_EQUATIONS_H
#define QUELL_NORMAL_EQUATIONS_H

#include "common/lanes.h"
#include "gram_params.h"

// Features without the constant one.
#define VARIED (QUELL_FEATURES - 1)
#define VARIED_ROOM (VARIED > 0 ? VARIED : 1)  // arrays must not be empty
// Element of the lower triangle of the normal matrix for row >= column.
#define LOWER(row, column) ((row) * ((row) + 1) / 2 + (column))

// Inverse standard deviations of the features; 0 drops one.
QUELL_INLINE void findDeviations(const floatL* sums, const floatL* mean, float noiseVariance,
                                 floatL* inverseDeviation) {
  const floatL weight = sums[QUELL_GRAM_INDEX(0, 0)];
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
}

// Row i of the normal matrix (lower triangle) and its right-hand sides, centred, regularised and normalised: the diagonal
// becomes 1, or 0 for a dropped feature.
QUELL_INLINE void makeNormalRow(const floatL* sums, const floatL* mean, const floatL* inverseDeviation, int i,
                                floatL* matrix, floatL* right) {
  UNROLL_ON_GPU
  for (int j = 0; j < i; ++j) {
    const floatL covariance =
        sums[QUELL_GRAM_INDEX(j + 1, i + 1)] - sums[QUELL_GRAM_INDEX(0, i + 1)] * mean[j + 1];
    matrix[LOWER(i, j)] = covariance * inverseDeviation[i] * inverseDeviation[j];
  }
  matrix[LOWER(i, i)] = inverseDeviation[i] > 0.0f ? ONE_LANES : ZERO_LANES;
  UNROLL_ON_GPU
  for (int c = 0; c < QUELL_FIT_CHANNELS; ++c) {
    const int column = QUELL_GRAM_FEATURES + c;
    right[c] = (sums[QUELL_GRAM_INDEX(i + 1, column)] - sums[QUELL_GRAM_INDEX(0, i + 1)] * mean[column]) *
               inverseDeviation[i];
  }
}

// Cholesky factor in place; the diagonal keeps the inverse of the factor's, 0 for a dropped feature.
QUELL_INLINE void factorise(floatL* factor) {
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
}

// Solution for the right-hand side of channel c.
QUELL_INLINE void substitute(const floatL* factor, floatL right[VARIED_ROOM][QUELL_FIT_CHANNELS], int c,
                             floatL* solution) {
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
}

// Coefficients of all features for every channel, from the window's sums.
QUELL_INLINE void solveWindow(const floatL* sums, float noiseVariance,
                              floatL coefficients[QUELL_FEATURES][QUELL_FIT_CHANNELS]) {
  const floatL weight = sums[QUELL_GRAM_INDEX(0, 0)];
  const floatL inverseWeight = 1.0f / (weight > 0.0f ? weight : ONE_LANES);
  floatL mean[QUELL_GRAM_COLUMNS];
  UNROLL_ON_GPU
  for (int k = 1; k < QUELL_GRAM_COLUMNS; ++k) mean[k] = sums[QUELL_GRAM_INDEX(0, k)] * inverseWeight;

  floatL inverseDeviation[VARIED_ROOM];
  findDeviations(sums, mean, noiseVariance, inverseDeviation);
  floatL factor[LOWER(VARIED_ROOM, 0)];
  floatL right[VARIED_ROOM][QUELL_FIT_CHANNELS];
  UNROLL_ON_GPU
  for (int i = 0; i < VARIED; ++i) makeNormalRow(sums, mean, inverseDeviation, i, factor, right[i]);
  factorise(factor);

  UNROLL_ON_GPU
  for (int c = 0; c < QUELL_FIT_CHANNELS; ++c) {
    floatL solution[VARIED_ROOM];
    substitute(factor, right, c, solution);
    floatL intercept = mean[QUELL_GRAM_FEATURES + c];
    UNROLL_ON_GPU
    for (int i = 0; i < VARIED; ++i) {
      coefficients[i + 1][c] = solution[i] * inverseDeviation[i];
      intercept -= coefficients[i + 1][c] * mean[i + 1];
    }
    coefficients[0][c] = intercept;
  }
}

#endif

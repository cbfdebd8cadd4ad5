// The matrix that fit.cl factorises, as the work-items of a block hold it: a column per feature and colour channel, a row
// per pixel.
#ifndef QUELL_FIT_COLUMNS_H
#define QUELL_FIT_COLUMNS_H

#include "common/lanes.h"
#include "fit_params.h"

#define LOGICAL_LANES 256
#define GROUP_LANES (GROUP_SIZE * QUELL_LANES)
// Rows of a work-item (in vectors of QUELL_LANES), as steps of chunks: row = 256 * step + lane within 256.
#define CHUNKS (LOGICAL_LANES / GROUP_LANES)
#define STEPS (QUELL_BLOCK_PIXELS / LOGICAL_LANES)
#define ITEM_ROWS (CHUNKS * STEPS)
// Of these, how many may hold the row of a pivot.
#define PIVOT_VECTORS ((QUELL_MOST_FEATURES + GROUP_LANES - 1) / GROUP_LANES)

// On GPUs every loop over rows and columns is unrolled, so that the columns live in registers.
#if FIT_UNROLL
#define UNROLL _Pragma("unroll")
#else
#define UNROLL
#endif

#if FIT_STORAGE_HALF
typedef struct Columns {
  __global half* data;
  int id;
} Columns;
#define COLUMN_INDEX(columns, k, i) \
  ((size_t)((k)*QUELL_BLOCK_PIXELS + ((i)*GROUP_SIZE + (columns).id) * QUELL_LANES))
#if QUELL_LANES > 1
#define GET(columns, k, i) TYPE_OF_LANES(vload_half)(0, (columns).data + COLUMN_INDEX(columns, k, i))
#define SET(columns, k, i, value) \
  TYPE_OF_LANES(vstore_half)((value), 0, (columns).data + COLUMN_INDEX(columns, k, i))
#else
#define GET(columns, k, i) vload_half(COLUMN_INDEX(columns, k, i), (columns).data)
#define SET(columns, k, i, value) vstore_half((value), COLUMN_INDEX(columns, k, i), (columns).data)
#endif
#define COLUMNS_ARGUMENT Columns columns
#else
#define GET(columns, k, i) columns[k][i]
#define SET(columns, k, i, value) columns[k][i] = (value)
#define COLUMNS_ARGUMENT floatL columns[QUELL_FIT_COLUMNS][ITEM_ROWS]
#endif

// Halving tree over the chunks of logical lanes that a work-item owns.
QUELL_INLINE floatL sumChunks(floatL* sums) {
  UNROLL
  for (int active = CHUNKS / 2; active > 0; active /= 2) {
    UNROLL
    for (int chunk = 0; chunk < active; ++chunk) sums[chunk] += sums[chunk + active];
  }
  return sums[0];
}

// Sum of a product of two columns over the rows of this work-item, per lane.
QUELL_INLINE floatL partialDot(COLUMNS_ARGUMENT, int a, int b) {
  floatL sums[CHUNKS];
  UNROLL
  for (int chunk = 0; chunk < CHUNKS; ++chunk) {
    floatL sum = GET(columns, a, chunk) * GET(columns, b, chunk);
    UNROLL
    for (int step = 1; step < STEPS; ++step)
      sum += GET(columns, a, step * CHUNKS + chunk) * GET(columns, b, step * CHUNKS + chunk);
    sums[chunk] = sum;
  }
  return sumChunks(sums);
}

// Column k minus `along` times column j.
QUELL_INLINE void reflect(COLUMNS_ARGUMENT, int k, int j, float along) {
  UNROLL
  for (int i = 0; i < ITEM_ROWS; ++i) SET(columns, k, i, GET(columns, k, i) - along * GET(columns, j, i));
}

// The same, and the product of the result with column p, summed as partialDot does.
QUELL_INLINE floatL reflectAndDot(COLUMNS_ARGUMENT, int k, int j, float along, int p) {
  floatL sums[CHUNKS];
  UNROLL
  for (int chunk = 0; chunk < CHUNKS; ++chunk) {
    floatL value = GET(columns, k, chunk) - along * GET(columns, j, chunk);
    SET(columns, k, chunk, value);
    floatL sum = value * GET(columns, p, chunk);
    UNROLL
    for (int step = 1; step < STEPS; ++step) {
      const int i = step * CHUNKS + chunk;
      value = GET(columns, k, i) - along * GET(columns, j, i);
      SET(columns, k, i, value);
      sum += value * GET(columns, p, i);
    }
    sums[chunk] = sum;
  }
  return sumChunks(sums);
}

#endif

// fit: least-squares fit of the features to the accumulated irradiance, one 32x32 block a work-group.
// Paper:   Koskela et al. 2019, phase II: augmented Householder QR [T + N, z], eq. (4) and (5), stochastic
//          regularisation with uniform noise N of amplitude epsilon, all colour channels at once.
// In:      irradiance (3 planes per signal, of which those of QUELL_SIGNAL are fitted) and guides (see
//          common/guides.h) of this frame; materials (4 planes) where a feature needs them; with TAP_WEIGHTS the
//          weights of pixels, instead of those of the guides.
// Out:     one record a block: coefficients of all features and the scaling of the unbounded ones (fit_params.h).
// Grid:    blocks are displaced by one of 16 offsets a frame; pixels outside the image are mirrored.
// Order:   every sum over the block runs over 256 logical lanes (pixel index modulo 256), each in ascending order,
//          then in a halving tree: the result does not depend on the work-group size.
// Departures: pixels are weighted (0: hole or background, little: firefly), rows by its square root; positions are
//          anchored at the block's minimum before they are squared, which spans the same space and needs no world
//          origin; the offsets are 16 evenly spread ones instead of random ones; the noise differs from block to
//          block; linearly dependent columns get no coefficient instead of a division by zero.
//
// GROUP_SIZE work-items share a block; each owns the rows (i * GROUP_SIZE + id) * QUELL_LANES + lane and keeps
// them in private memory: with 256 work-items that is 52 registers and no traffic but the input; with one work-item
// and 16 lanes it is a stack array that stays in a CPU's nearest caches. FIT_STORAGE_HALF puts the columns into
// global memory as halves, block after block, as the reference does.
#include "common/blocks.h"
#include "common/fit_inputs.h"
#include "common/planes.h"
#include "common/random.h"
#include "fit_columns.h"
#include "fit_ports.h"

// Numbers that a work-group sums, or takes the least of, at once.
#define EXCHANGED (BOUNDS > QUELL_FIT_COLUMNS ? BOUNDS : QUELL_FIT_COLUMNS)

typedef struct Block {
  int number;
  int x;  // of its first pixel
  int y;
} Block;

// First of the QUELL_LANES pixels of a block that are vector i of a work-item.
QUELL_INLINE int firstPixel(int id, int i) { return (i * GROUP_SIZE + id) * QUELL_LANES; }

// Sums of per-item values `first` to `end` - 1 over the work-group, in a halving tree. All work-items get the result.
QUELL_INLINE void groupSum(__local floatL* exchange, int id, floatL* values, int first, int end) {
#if GROUP_SIZE > 1
  UNROLL
  for (int k = first; k < end; ++k) exchange[k * GROUP_SIZE + id] = values[k];
  GROUP_BARRIER;
  for (int active = GROUP_SIZE / 2; active > 0; active /= 2) {
    if (id < active) {
      UNROLL
      for (int k = first; k < end; ++k)
        exchange[k * GROUP_SIZE + id] += exchange[k * GROUP_SIZE + id + active];
    }
    GROUP_BARRIER;
  }
  UNROLL
  for (int k = first; k < end; ++k) values[k] = exchange[k * GROUP_SIZE];
  GROUP_BARRIER;
#endif
}

// Scaling of the unbounded variables by their ranges in the block.
QUELL_INLINE void scaleBlock(FitInputs inputs, Block block, int id, __local floatL* exchange, float* anchor,
                             float* scale) {
#if QUELL_SCALED > 0
  floatL bounds[BOUNDS];
  beginRange(bounds);
  UNROLL
  for (int i = 0; i < ITEM_ROWS; ++i) {
    const GatherPlan plan = planBlockRow(inputs.planes, firstPixel(id, i), block.x, block.y);
    includeRange(inputs, plan, gatherWeight(inputs, plan), bounds);
  }
  groupMin(exchange, id, bounds);
  float low[QUELL_SCALED], high[QUELL_SCALED];
  endRange(bounds, low, high);
  scaleRanges(low, high, anchor, scale);
#endif
}

// The augmented matrix [T + N, z], rows weighted.
QUELL_INLINE void fillColumns(COLUMNS_ARGUMENT, FitInputs inputs, FitParams params, Block block, int id,
                              const float* anchor, const float* scale) {
  const int stride = inputs.planes.stride;
  const uint blockSeed = hashScalar(params.noiseSeed + (uint)block.number);
  UNROLL
  for (int i = 0; i < ITEM_ROWS; ++i) {
    const int row = firstPixel(id, i);
    const GatherPlan plan = planBlockRow(inputs.planes, row, block.x, block.y);
    const floatL rootWeight = SQRT(gatherWeight(inputs, plan));
    floatL features[QUELL_FEATURES];
    makeFeatures(features, gatherInputs(inputs, plan), inputs.viewAxis, anchor, scale);
    UNROLL
    for (int k = 0; k < QUELL_FEATURES; ++k) {
      const uintL counter = AS_UINT((intL)(row + k * QUELL_BLOCK_PIXELS) + LANE_INDEX) ^ blockSeed;
      const floatL noise = k > 0 ? params.noiseAmplitude * signedUnit(hashLanes(counter)) : ZERO_LANES;
      const floatL value = (features[k] + noise) * rootWeight;
      SET(columns, k, i, rootWeight > 0.0f ? value : ZERO_LANES);
    }
    UNROLL
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      SET(columns, QUELL_FEATURES + c, i,
          gatherLanes(inputs.irradiance + (3 * QUELL_SIGNAL + c) * stride, plan) * rootWeight);
  }
}

// Row j of the columns from j on, for the work-group.
QUELL_INLINE void sharePivotRow(COLUMNS_ARGUMENT, int j, int id, __local float* pivotRow) {
  UNROLL
  for (int k = j; k < QUELL_FIT_COLUMNS; ++k) {
    floatL pivot = GET(columns, k, j / GROUP_LANES);
    if (id == j / QUELL_LANES % GROUP_SIZE) pivotRow[k] = ((float*)&pivot)[j % QUELL_LANES];
  }
}

// Householder reflection that takes a pivot column x to `diagonal` in the pivot row and 0 in the others of the game.
typedef struct Reflection {
  int dependent;   // on the columns before: there is none
  float head;      // of x in the pivot row
  float diagonal;  // -+ length of x
  float factor;    // 2 / (v'v) for v = x - diagonal * e_j
} Reflection;

QUELL_INLINE Reflection makeReflection(float energy, float tolerance, float head) {
  Reflection reflection;
  const float length = sqrt(energy);
  reflection.dependent = energy <= tolerance;
  reflection.head = head;
  reflection.diagonal = head > 0.0f ? -length : length;
  reflection.factor = reflection.dependent ? 0.0f : 1.0f / (energy + fabs(head) * length);
  return reflection;
}

// Zeros in the rows of column k that belong to R, which are among the first.
QUELL_INLINE void leaveOutTaken(COLUMNS_ARGUMENT, int k, int id, int takenRows) {
  UNROLL
  for (int i = 0; i < PIVOT_VECTORS; ++i) {
    const intL rows = (intL)(firstPixel(id, i)) + LANE_INDEX;
    const intL taken = rows < QUELL_FEATURES &&
                       (((intL)(takenRows) >> minLanesInt(rows, (intL)(QUELL_MOST_FEATURES - 1))) & 1) != 0;
    SET(columns, k, i, taken ? ZERO_LANES : GET(columns, k, i));
  }
}

// Applies reflection j to the columns after j, in one pass that also sums the products that step j + 1 needs; row j
// of R goes to `row`. The column that is the next pivot gets zeros in the rows that belong to R.
QUELL_INLINE void applyReflection(COLUMNS_ARGUMENT, Reflection reflection, int j, int id, int takenRows,
                                  __local const float* pivotRow, __local float* row, floatL* dots) {
  if (id == 0) row[j] = reflection.dependent ? 0.0f : reflection.diagonal;
  UNROLL
  for (int k = j + 1; k < QUELL_FIT_COLUMNS; ++k) {
    const float along = (sumLanes(dots[k]) - reflection.diagonal * pivotRow[k]) * reflection.factor;
    if (id == 0) row[k] = pivotRow[k] - along * (reflection.head - reflection.diagonal);
    // After the last feature only R is wanted.
    if (j + 1 == QUELL_FEATURES) continue;
    if (k == j + 1) {
      reflect(columns, k, j, along);
      leaveOutTaken(columns, k, id, takenRows);
      dots[k] = partialDot(columns, k, k);
    } else {
      dots[k] = reflectAndDot(columns, k, j, along, j + 1);
    }
  }
}

// Back substitution, eq. (5): one colour channel a work-item.
QUELL_INLINE void substituteBack(__local float (*r)[QUELL_FIT_COLUMNS], int id, __global float* record) {
  for (int c = id; c < QUELL_FIT_CHANNELS; c += GROUP_SIZE) {
    float coefficients[QUELL_FEATURES];
    UNROLL
    for (int j = QUELL_FEATURES - 1; j >= 0; --j) {
      float sum = r[j][QUELL_FEATURES + c];
      UNROLL
      for (int k = j + 1; k < QUELL_FEATURES; ++k) sum -= r[j][k] * coefficients[k];
      coefficients[j] = r[j][j] != 0.0f ? sum / r[j][j] : 0.0f;
    }
    UNROLL
    for (int j = 0; j < QUELL_FEATURES; ++j) record[j * QUELL_FIT_CHANNELS + c] = coefficients[j];
  }
}

__kernel
#if GROUP_SIZE > 1
    __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1)))
#endif
    void
    fit(STAGE_ARGUMENTS(FIT) FitParams params) {
  const int id = (int)get_local_id(0);
  const int number = (int)get_group_id(0);
  const Block block = {number, params.blockOffsetX + (number % params.blocksX) * QUELL_BLOCK_EDGE,
                       params.blockOffsetY + (number / params.blocksX) * QUELL_BLOCK_EDGE};
  const FitInputs inputs = FIT_INPUTS(params);
  __global float* record = fitRecords + number * QUELL_FIT_RECORD;
#if SKIP && GROUP_SIZE == 1
  // A work-group would have to agree on it before a barrier; one work-item does not.
  if (!anySurfaceInBlock(surfaces, params.planes, block.x, block.y, QUELL_BLOCK_EDGE)) {
    record[QUELL_FIT_USABLE] = 0.0f;
    return;
  }
#endif

#if GROUP_SIZE > 1
  __local floatL exchange[EXCHANGED * GROUP_SIZE];
#else
  __local floatL exchange[1];
#endif
  __local float pivotRow[QUELL_FIT_COLUMNS];
  __local float r[QUELL_FEATURES][QUELL_FIT_COLUMNS];

#if FIT_STORAGE_HALF
  const Columns columns = {fitStorage + (size_t)number * (QUELL_FIT_COLUMNS * QUELL_BLOCK_PIXELS), id};
#else
  floatL columns[QUELL_FIT_COLUMNS][ITEM_ROWS];
#endif

  float anchor[QUELL_SCALED_SLOTS], scale[QUELL_SCALED_SLOTS];
  scaleBlock(inputs, block, id, exchange, anchor, scale);
  fillColumns(columns, inputs, params, block, id, anchor, scale);

  // Householder QR. Step j reflects the pivot column j onto row j, which then belongs to R and is out of the game: the
  // pivot columns that follow have zeros there, which keeps it out of every sum and update. A dependent column leaves
  // its row in the game.
  int takenRows = 0;  // bit j: row j belongs to R
  float tolerance = 0.0f;
  floatL dots[QUELL_FIT_COLUMNS];
  UNROLL
  for (int k = 0; k < QUELL_FIT_COLUMNS; ++k) dots[k] = partialDot(columns, 0, k);
  UNROLL
  for (int j = 0; j < QUELL_FEATURES; ++j) {
    sharePivotRow(columns, j, id, pivotRow);
    groupSum(exchange, id, dots, j, QUELL_FIT_COLUMNS);
    GROUP_BARRIER;
    const float energy = sumLanes(dots[j]);
    tolerance = j == 0 ? energy * QUELL_FIT_RANK_TOLERANCE : tolerance;
    const Reflection reflection = makeReflection(energy, tolerance, pivotRow[j]);
    takenRows |= reflection.dependent ? 0 : 1 << j;
    applyReflection(columns, reflection, j, id, takenRows, pivotRow, r[j], dots);
    GROUP_BARRIER;
  }

  substituteBack(r, id, record);
  if (id == 0) {
    record[QUELL_FIT_USABLE] = r[0][0] != 0.0f ? 1.0f : 0.0f;
    for (int k = 0; k < QUELL_SCALED; ++k) {
      record[QUELL_FIT_ANCHOR + k] = anchor[k];
      record[QUELL_FIT_SCALE + k] = scale[k];
    }
  }
}

// fit: least-squares fit of the features to the accumulated irradiance, one 32x32 block a work-group.
// Paper:   Koskela et al. 2019, phase II: augmented Householder QR [T + N, z], eq. (4) and (5), stochastic
//          regularisation with uniform noise N of amplitude epsilon, all colour channels at once.
// In:      irradiance (3 planes per signal, of which those of QUELL_SIGNAL are fitted) and guides (see
//          common/guides.h) of this frame; materials (4 planes) where a feature needs them.
// Out:     one record a block: coefficients of all features and the scaling of the unbounded ones (fit_params.h).
// Grid:    blocks are displaced by one of 16 offsets a frame; pixels outside the image are mirrored.
// Order:   every sum over the block runs over 256 logical lanes (pixel index modulo 256), each in ascending order,
//          then in a halving tree: the result does not depend on the work-group size.
// Departures: pixels are weighted by guides.weight (0: hole or background), rows by its square root; positions are
//          anchored at the block's minimum before they are squared, which spans the same space and needs no world
//          origin; the offsets are 16 evenly spread ones instead of random ones; the noise differs from block to
//          block; linearly dependent columns get no coefficient instead of a division by zero.
//
// FIT_GROUP_SIZE work-items share a block; each owns the rows (i * FIT_GROUP_SIZE + id) * QUELL_LANES + lane and keeps
// them in private memory: with 256 work-items that is 52 registers and no traffic but the input; with one work-item
// and 16 lanes it is a stack array that stays in a CPU's nearest caches. FIT_STORAGE_HALF puts the columns into
// global memory as halves, block after block, as the reference does.
#include "accumulate_noisy_params.h"
#include "common/blocks.h"
#include "common/fit_features.h"
#include "common/guides.h"
#include "common/planes.h"
#include "common/random.h"
#include "fit_params.h"

#define LOGICAL_LANES 256
#define GROUP_LANES (FIT_GROUP_SIZE * QUELL_LANES)
// Rows of a work-item (in vectors of QUELL_LANES), as steps of chunks: row = 256 * step + lane within 256.
#define CHUNKS (LOGICAL_LANES / GROUP_LANES)
#define STEPS (QUELL_BLOCK_PIXELS / LOGICAL_LANES)
#define ITEM_ROWS (CHUNKS * STEPS)

// Numbers that a work-group sums, or takes the least of, at once.
#define BOUNDS (2 * QUELL_SCALED)
#define EXCHANGED (BOUNDS > QUELL_FIT_COLUMNS ? BOUNDS : QUELL_FIT_COLUMNS)

// On GPUs every loop over rows and columns is unrolled, so that the columns live in registers.
#if FIT_UNROLL
#define UNROLL _Pragma("unroll")
#else
#define UNROLL
#endif

#if FIT_GROUP_SIZE == 1
#define GROUP_BARRIER
#else
#define GROUP_BARRIER barrier(CLK_LOCAL_MEM_FENCE)
#endif

#if FIT_STORAGE_HALF
typedef struct Columns {
  __global half* data;
  int id;
} Columns;
#define COLUMN_INDEX(columns, k, i) \
  ((size_t)((k)*QUELL_BLOCK_PIXELS + ((i)*FIT_GROUP_SIZE + (columns).id) * QUELL_LANES))
#if QUELL_LANES == 16
#define GET(columns, k, i) vload_half16(0, (columns).data + COLUMN_INDEX(columns, k, i))
#define SET(columns, k, i, value) vstore_half16((value), 0, (columns).data + COLUMN_INDEX(columns, k, i))
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

// Sums of per-item values `first` to `end` - 1 over the work-group, in a halving tree. All work-items get the result.
QUELL_INLINE void groupSum(__local floatL* exchange, int id, floatL* values, int first, int end) {
#if FIT_GROUP_SIZE > 1
  UNROLL
  for (int k = first; k < end; ++k) exchange[k * FIT_GROUP_SIZE + id] = values[k];
  GROUP_BARRIER;
  for (int active = FIT_GROUP_SIZE / 2; active > 0; active /= 2) {
    if (id < active) {
      UNROLL
      for (int k = first; k < end; ++k)
        exchange[k * FIT_GROUP_SIZE + id] += exchange[k * FIT_GROUP_SIZE + id + active];
    }
    GROUP_BARRIER;
  }
  UNROLL
  for (int k = first; k < end; ++k) values[k] = exchange[k * FIT_GROUP_SIZE];
  GROUP_BARRIER;
#endif
}

#if QUELL_SCALED > 0
QUELL_INLINE void groupMin(__local floatL* exchange, int id, floatL* values, int count) {
#if FIT_GROUP_SIZE > 1
  UNROLL
  for (int k = 0; k < count; ++k) exchange[k * FIT_GROUP_SIZE + id] = values[k];
  GROUP_BARRIER;
  for (int active = FIT_GROUP_SIZE / 2; active > 0; active /= 2) {
    if (id < active) {
      UNROLL
      for (int k = 0; k < count; ++k)
        exchange[k * FIT_GROUP_SIZE + id] =
            minLanes(exchange[k * FIT_GROUP_SIZE + id], exchange[k * FIT_GROUP_SIZE + id + active]);
    }
    GROUP_BARRIER;
  }
  UNROLL
  for (int k = 0; k < count; ++k) values[k] = exchange[k * FIT_GROUP_SIZE];
  GROUP_BARRIER;
#endif
}
#endif

__kernel
#if FIT_GROUP_SIZE > 1
    __attribute__((reqd_work_group_size(FIT_GROUP_SIZE, 1, 1)))
#endif
    void
    fit(__global const float* irradiance, __global const float* guides, __global const float* materials,
        __global float* records, __global half* storage, FitParams params) {
  const int id = (int)get_local_id(0);
  const int block = (int)get_group_id(0);
  const int blockX = params.blockOffsetX + (block % params.blocksX) * QUELL_BLOCK_EDGE;
  const int blockY = params.blockOffsetY + (block / params.blocksX) * QUELL_BLOCK_EDGE;
  const int stride = params.planes.stride;

#if FIT_GROUP_SIZE > 1
  __local floatL exchange[EXCHANGED * FIT_GROUP_SIZE];
#else
  __local floatL exchange[1];
#endif
  __local float pivotRow[QUELL_FIT_COLUMNS];
  __local float r[QUELL_FEATURES][QUELL_FIT_COLUMNS];

#if FIT_STORAGE_HALF
  Columns columns;
  columns.data = storage + (size_t)block * (QUELL_FIT_COLUMNS * QUELL_BLOCK_PIXELS);
  columns.id = id;
#else
  floatL columns[QUELL_FIT_COLUMNS][ITEM_ROWS];
#endif

  float anchor[QUELL_SCALED_SLOTS], scale[QUELL_SCALED_SLOTS];
#if QUELL_SCALED > 0
  // Range of the unbounded variables: minima of v and of -v over the pixels with a weight.
  floatL bounds[BOUNDS];
  UNROLL
  for (int k = 0; k < BOUNDS; ++k) bounds[k] = (floatL)(NO_POSITION);
  UNROLL
  for (int i = 0; i < ITEM_ROWS; ++i) {
    const GatherPlan plan =
        planBlockRow(params.planes, (i * FIT_GROUP_SIZE + id) * QUELL_LANES, blockX, blockY);
    const intL used = gatherLanes(guides + (QUELL_GUIDE_WEIGHT + QUELL_SIGNAL) * stride, plan) > 0.0f;
    floatL scaled[QUELL_SCALED];
    makeScaled(scaled, gatherGuide(guides, materials, params.planes, plan), params.viewAxis);
    UNROLL
    for (int k = 0; k < QUELL_SCALED; ++k) {
      const floatL v = scaled[k];
      bounds[k] = used && v < bounds[k] ? v : bounds[k];
      bounds[k + QUELL_SCALED] = used && -v < bounds[k + QUELL_SCALED] ? -v : bounds[k + QUELL_SCALED];
    }
  }
  groupMin(exchange, id, bounds, BOUNDS);
  float low[QUELL_SCALED], high[QUELL_SCALED];
  UNROLL
  for (int k = 0; k < QUELL_SCALED; ++k) {
    low[k] = minOfLanes(bounds[k]);
    high[k] = -minOfLanes(bounds[k + QUELL_SCALED]);
  }
  scaleRanges(low, high, anchor, scale);
#endif

  // The augmented matrix [T + N, z], rows weighted.
  const uint blockSeed = hashScalar(params.noiseSeed + (uint)block);
  UNROLL
  for (int i = 0; i < ITEM_ROWS; ++i) {
    const int row = (i * FIT_GROUP_SIZE + id) * QUELL_LANES;
    const GatherPlan plan = planBlockRow(params.planes, row, blockX, blockY);
    const floatL rootWeight = SQRT(gatherLanes(guides + (QUELL_GUIDE_WEIGHT + QUELL_SIGNAL) * stride, plan));
    const Guide guide = gatherGuide(guides, materials, params.planes, plan);
    floatL features[QUELL_FEATURES];
    makeFeatures(features, guide, params.viewAxis, anchor, scale);
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
          gatherLanes(irradiance + (3 * QUELL_SIGNAL + c) * stride, plan) * rootWeight);
  }

  // Householder QR. Step j reflects the pivot column j onto row j, which then belongs to R and is out of the game: the
  // pivot columns that follow have zeros there, which keeps it out of every sum and update. A dependent column leaves
  // its row in the game. One pass per column applies reflection j and sums the products that step j + 1 needs.
  const intL firstRows = (intL)(id * QUELL_LANES) + LANE_INDEX;
  int takenRows = 0;  // bit j: row j belongs to R
  float tolerance = 0.0f;
  floatL dots[QUELL_FIT_COLUMNS];
  UNROLL
  for (int k = 0; k < QUELL_FIT_COLUMNS; ++k) dots[k] = partialDot(columns, 0, k);
  UNROLL
  for (int j = 0; j < QUELL_FEATURES; ++j) {
    UNROLL
    for (int k = j; k < QUELL_FIT_COLUMNS; ++k) {
      floatL pivot = GET(columns, k, 0);
      if (id == j / QUELL_LANES) pivotRow[k] = ((float*)&pivot)[j % QUELL_LANES];
    }
    groupSum(exchange, id, dots, j, QUELL_FIT_COLUMNS);
    GROUP_BARRIER;

    const float energy = sumLanes(dots[j]);
    tolerance = j == 0 ? energy * QUELL_FIT_RANK_TOLERANCE : tolerance;
    const int dependent = energy <= tolerance;
    const float head = pivotRow[j];
    const float length = sqrt(energy);
    const float diagonal = head > 0.0f ? -length : length;
    // 2 / (v'v) for v = x - diagonal * e_j
    const float reflection = dependent ? 0.0f : 1.0f / (energy + fabs(head) * length);
    takenRows |= dependent ? 0 : 1 << j;
    if (id == 0) r[j][j] = dependent ? 0.0f : diagonal;
    UNROLL
    for (int k = j + 1; k < QUELL_FIT_COLUMNS; ++k) {
      const float along = (sumLanes(dots[k]) - diagonal * pivotRow[k]) * reflection;
      if (id == 0) r[j][k] = pivotRow[k] - along * (head - diagonal);
      // After the last feature only R is wanted.
      if (j + 1 < QUELL_FEATURES) {
        if (k == j + 1) {
          reflect(columns, k, j, along);
          const intL taken = firstRows < QUELL_FEATURES &&
                             (((intL)(takenRows) >> minLanesInt(firstRows, (intL)(15))) & 1) != 0;
          SET(columns, k, 0, taken ? ZERO_LANES : GET(columns, k, 0));
          dots[k] = partialDot(columns, k, k);
        } else {
          dots[k] = reflectAndDot(columns, k, j, along, j + 1);
        }
      }
    }
    GROUP_BARRIER;
  }

  // Back substitution, eq. (5): one colour channel a work-item.
  for (int c = id; c < QUELL_FIT_CHANNELS; c += FIT_GROUP_SIZE) {
    float coefficients[QUELL_FEATURES];
    UNROLL
    for (int j = QUELL_FEATURES - 1; j >= 0; --j) {
      float sum = r[j][QUELL_FEATURES + c];
      UNROLL
      for (int k = j + 1; k < QUELL_FEATURES; ++k) sum -= r[j][k] * coefficients[k];
      coefficients[j] = r[j][j] != 0.0f ? sum / r[j][j] : 0.0f;
    }
    UNROLL
    for (int j = 0; j < QUELL_FEATURES; ++j)
      records[block * QUELL_FIT_RECORD + j * QUELL_FIT_CHANNELS + c] = coefficients[j];
  }
  if (id == 0) {
    __global float* record = records + block * QUELL_FIT_RECORD;
    record[QUELL_FIT_USABLE] = r[0][0] != 0.0f ? 1.0f : 0.0f;
    for (int k = 0; k < QUELL_SCALED; ++k) {
      record[QUELL_FIT_ANCHOR + k] = anchor[k];
      record[QUELL_FIT_SCALE + k] = scale[k];
    }
  }
}

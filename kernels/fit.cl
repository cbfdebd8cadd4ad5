// fit: least-squares fit of the features to the accumulated irradiance, one 32x32 block a work-group.
// Paper:   Koskela et al. 2019, phase II: augmented Householder QR [T + N, z], eq. (4) to (6), stochastic
//          regularisation with uniform noise N of amplitude epsilon, all colour channels at once.
// In:      irradiance (3 planes) and guides (7 planes) of this frame.
// Out:     one record a block: 10 x 3 coefficients and the scaling of the positions (fit_params.h).
// Grid:    blocks are displaced by one of 16 offsets a frame; pixels outside the image are mirrored.
// Order:   every sum over the block runs over 256 logical lanes (pixel index modulo 256), each in ascending order,
//          then in a halving tree: the result does not depend on the work-group size.
// Departures: pixels are weighted by guides.weight (0: hole or background), rows by its square root; positions are
//          anchored at the block's minimum before they are squared, which spans the same space and needs no world
//          origin; the noise differs from block to block; linearly dependent columns get no coefficient instead of a
//          division by zero.
//
// FIT_GROUP_SIZE work-items share a block; each owns the rows (i * FIT_GROUP_SIZE + id) * QUELL_LANES + lane and keeps
// them in private memory: with 256 work-items that is 52 registers and no traffic but the input; with one work-item
// and 16 lanes it is a stack array that stays in a CPU's nearest caches. FIT_STORAGE_HALF puts the columns into
// global memory as halves, block after block, as the reference does.
#include "common/fit_features.h"
#include "common/planes.h"
#include "common/random.h"
#include "accumulate_noisy_params.h"
#include "fit_params.h"

#define LOGICAL_LANES 256
#define GROUP_LANES (FIT_GROUP_SIZE * QUELL_LANES)
// Rows of a work-item (in vectors of QUELL_LANES), as steps of chunks: row = 256 * step + lane within 256.
#define CHUNKS (LOGICAL_LANES / GROUP_LANES)
#define STEPS (QUELL_BLOCK_PIXELS / LOGICAL_LANES)
#define ITEM_ROWS (CHUNKS * STEPS)

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
  ((size_t)((k) * QUELL_BLOCK_PIXELS + ((i) * FIT_GROUP_SIZE + (columns).id) * QUELL_LANES))
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

QUELL_INLINE int mirror(int i, int size) {
  // Reflections repeat with period 2 * size, which matters where the image is smaller than a block.
  int folded = i % (2 * size);
  folded = folded < 0 ? folded + 2 * size : folded;
  return folded < size ? folded : 2 * size - 1 - folded;
}

QUELL_INLINE GatherPlan planBlockRow(FitParams params, int row, int blockX, int blockY) {
  const int x = blockX + (row & (QUELL_BLOCK_EDGE - 1));
  const int y = mirror(blockY + row / QUELL_BLOCK_EDGE, params.planes.height);
  GatherPlan plan;
#if QUELL_LANES == 1
  plan.index = planeIndex(params.planes, mirror(x, params.planes.width), y);
#else
  if (x >= 0 && x + 16 <= params.planes.width) {
    plan.index = planeIndex(params.planes, x, y) + LANE_INDEX;
    plan.firstRun = planeIndex(params.planes, x, y);
    plan.lastRun = plan.firstRun;
    plan.inFirstRun = (intL)(-1);
    plan.runs = 1;
  } else {
    int columns[16];
    for (int lane = 0; lane < 16; ++lane) columns[lane] = mirror(x + lane, params.planes.width);
    plan = planGather(planeIndex(params.planes, 0, y) + vload16(0, columns));
  }
#endif
  return plan;
}

QUELL_INLINE float sumLanes(floatL v) {
#if QUELL_LANES == 1
  return v;
#else
  const float8 a = v.lo + v.hi;
  const float4 b = a.lo + a.hi;
  const float2 c = b.lo + b.hi;
  return c.x + c.y;
#endif
}

QUELL_INLINE float minOfLanes(floatL v) {
#if QUELL_LANES == 1
  return v;
#else
  const float8 a = v.lo < v.hi ? v.lo : v.hi;
  const float4 b = a.lo < a.hi ? a.lo : a.hi;
  const float2 c = b.lo < b.hi ? b.lo : b.hi;
  return c.x < c.y ? c.x : c.y;
#endif
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
  for (int active = CHUNKS / 2; active > 0; active /= 2)
    UNROLL
    for (int chunk = 0; chunk < active; ++chunk) sums[chunk] += sums[chunk + active];
  return sums[0];
}

// Sums of `count` per-item values over the work-group, in a halving tree. All work-items get the result.
QUELL_INLINE void groupSum(__local floatL* exchange, int id, floatL* values, int first, int count) {
#if FIT_GROUP_SIZE > 1
  UNROLL
  for (int k = first; k < count; ++k) exchange[k * FIT_GROUP_SIZE + id] = values[k];
  GROUP_BARRIER;
  for (int active = FIT_GROUP_SIZE / 2; active > 0; active /= 2) {
    if (id < active) {
      UNROLL
      for (int k = first; k < count; ++k)
        exchange[k * FIT_GROUP_SIZE + id] += exchange[k * FIT_GROUP_SIZE + id + active];
    }
    GROUP_BARRIER;
  }
  UNROLL
  for (int k = first; k < count; ++k) values[k] = exchange[k * FIT_GROUP_SIZE];
  GROUP_BARRIER;
#endif
}

QUELL_INLINE void groupMin(__local floatL* exchange, int id, floatL* values, int count) {
#if FIT_GROUP_SIZE > 1
  UNROLL
  for (int k = 0; k < count; ++k) exchange[k * FIT_GROUP_SIZE + id] = values[k];
  GROUP_BARRIER;
  for (int active = FIT_GROUP_SIZE / 2; active > 0; active /= 2) {
    if (id < active) {
      UNROLL
      for (int k = 0; k < count; ++k)
        exchange[k * FIT_GROUP_SIZE + id] = minLanes(exchange[k * FIT_GROUP_SIZE + id],
                                                     exchange[k * FIT_GROUP_SIZE + id + active]);
    }
    GROUP_BARRIER;
  }
  UNROLL
  for (int k = 0; k < count; ++k) values[k] = exchange[k * FIT_GROUP_SIZE];
  GROUP_BARRIER;
#endif
}

// Larger than any position; the identity of the minimum.
#define NO_POSITION 3e38f

__kernel
#if FIT_GROUP_SIZE > 1
    __attribute__((reqd_work_group_size(FIT_GROUP_SIZE, 1, 1)))
#endif
    void fit(__global const float* irradiance, __global const float* guides, __global float* records,
             __global half* storage, FitParams params) {
  const int id = (int)get_local_id(0);
  const int block = (int)get_group_id(0);
  const int blockX = params.blockOffsetX + (block % params.blocksX) * QUELL_BLOCK_EDGE;
  const int blockY = params.blockOffsetY + (block / params.blocksX) * QUELL_BLOCK_EDGE;
  const int stride = params.planes.stride;

#if FIT_GROUP_SIZE > 1
  __local floatL exchange[QUELL_FIT_COLUMNS * FIT_GROUP_SIZE];
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

  // Range of the positions: minima of p and of -p over the pixels with a weight.
  floatL bounds[6];
  UNROLL
  for (int k = 0; k < 6; ++k) bounds[k] = (floatL)(NO_POSITION);
  UNROLL
  for (int i = 0; i < ITEM_ROWS; ++i) {
    const GatherPlan plan = planBlockRow(params, (i * FIT_GROUP_SIZE + id) * QUELL_LANES, blockX, blockY);
    const intL used = gatherLanes(guides + QUELL_GUIDE_WEIGHT * stride, plan) > 0.0f;
    UNROLL
    for (int axis = 0; axis < 3; ++axis) {
      const floatL p = gatherLanes(guides + (QUELL_GUIDE_POSITION + axis) * stride, plan);
      bounds[axis] = used && p < bounds[axis] ? p : bounds[axis];
      bounds[axis + 3] = used && -p < bounds[axis + 3] ? -p : bounds[axis + 3];
    }
  }
  groupMin(exchange, id, bounds, 6);
  float anchor[3], scale[3], centreSquared = 0.0f;
  UNROLL
  for (int axis = 0; axis < 3; ++axis) {
    const float low = minOfLanes(bounds[axis]);
    const float high = -minOfLanes(bounds[axis + 3]);
    const int empty = low > high;
    anchor[axis] = empty ? 0.0f : low;
    scale[axis] = empty ? 0.0f : high - low;
    centreSquared += empty ? 0.0f : 0.25f * (low + high) * (low + high);
  }
  const float leastRange = QUELL_FIT_LEAST_RANGE * sqrt(centreSquared);
  UNROLL
  for (int axis = 0; axis < 3; ++axis) scale[axis] = scale[axis] > leastRange ? 1.0f / scale[axis] : 1.0f;

  // The augmented matrix [T + N, z], rows weighted.
  const uint blockSeed = hashScalar(params.noiseSeed + (uint)block);
  UNROLL
  for (int i = 0; i < ITEM_ROWS; ++i) {
    const int row = (i * FIT_GROUP_SIZE + id) * QUELL_LANES;
    const GatherPlan plan = planBlockRow(params, row, blockX, blockY);
    const floatL rootWeight = SQRT(gatherLanes(guides + QUELL_GUIDE_WEIGHT * stride, plan));
    float3L position = gatherLanes3(guides + QUELL_GUIDE_POSITION * stride, plan, stride);
    position.x = (position.x - anchor[0]) * scale[0];
    position.y = (position.y - anchor[1]) * scale[1];
    position.z = (position.z - anchor[2]) * scale[2];
    floatL features[QUELL_FEATURES];
    makeFeatures(features, gatherLanes3(guides + QUELL_GUIDE_NORMAL * stride, plan, stride), position);
    UNROLL
    for (int k = 0; k < QUELL_FEATURES; ++k) {
      const uintL counter = AS_UINT((intL)(row + k * QUELL_BLOCK_PIXELS) + LANE_INDEX) ^ blockSeed;
      const floatL noise = k > 0 ? params.noiseAmplitude * signedUnit(hashLanes(counter)) : ZERO_LANES;
      const floatL value = (features[k] + noise) * rootWeight;
      SET(columns, k, i, rootWeight > 0.0f ? value : ZERO_LANES);
    }
    UNROLL
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      SET(columns, QUELL_FEATURES + c, i, gatherLanes(irradiance + c * stride, plan) * rootWeight);
  }

  // Householder QR: after step j, row j holds R and no longer takes part, so it is set to zero.
  const intL firstRows = (intL)(id * QUELL_LANES) + LANE_INDEX;
  float tolerance = 0.0f;
  UNROLL
  for (int j = 0; j < QUELL_FEATURES; ++j) {
    floatL dots[QUELL_FIT_COLUMNS];
    UNROLL
    for (int k = j; k < QUELL_FIT_COLUMNS; ++k) dots[k] = partialDot(columns, j, k);
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
    UNROLL
    for (int k = j + 1; k < QUELL_FIT_COLUMNS; ++k) {
      const float along = (sumLanes(dots[k]) - diagonal * pivotRow[k]) * reflection;
      if (id == 0) r[j][k] = pivotRow[k] - along * (head - diagonal);
      UNROLL
      for (int i = 0; i < ITEM_ROWS; ++i) SET(columns, k, i, GET(columns, k, i) - along * GET(columns, j, i));
      // A dependent column leaves its row in the game.
      if (!dependent) SET(columns, k, 0, firstRows == j ? ZERO_LANES : GET(columns, k, 0));
    }
    if (id == 0) r[j][j] = dependent ? 0.0f : diagonal;
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
    records[block * QUELL_FIT_RECORD + QUELL_FIT_ANCHOR + c] = anchor[c];
    records[block * QUELL_FIT_RECORD + QUELL_FIT_SCALE + c] = scale[c];
  }
}

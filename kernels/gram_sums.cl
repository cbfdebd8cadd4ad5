// gram_sums: sums over a tile of all products of features and colours: everything a least-squares fit needs.
// Paper:   the normal equations of Koskela et al. 2019, eq. (2); the features of its eq. (1) as in fit.cl.
// In:      irradiance (3 planes per signal, of which those of QUELL_SIGNAL are fitted) and guides (see
//          common/guides.h) of this frame; materials (4 planes) where a feature needs them.
// Out:     per tile the upper triangle of the weighted Gram matrix of [features | colour] and the range of the
//          unbounded variables, one plane per number (gram_params.h); they are scaled to [0, 1] by it, as in fit.cl.
// Tiles:   GRAM_TILE_EDGE pixels square. With GRAM_MIRROR pixels outside the image are mirrored (blocks of 32, as in
//          fit.cl), else they are left out.
// Why:     the factorisation in fit.cl makes 85 passes over columns of 1024 numbers; this is one pass over the pixels.
//
// GRAM_GROUP_SIZE 1: one work-item a tile, sixteen pixels at once, all sums (91 of ten features) held by it. Above: the
// work-group stages columns in local memory and every work-item owns some of the sums. Both add in one fixed order.
#include "accumulate_noisy_params.h"
#include "common/blocks.h"
#include "common/fit_features.h"
#include "common/guides.h"
#include "common/planes.h"
#include "gram_params.h"

#define TILE_PIXELS (GRAM_TILE_EDGE * GRAM_TILE_EDGE)

// Ends of the ranges of a tile.
#define BOUNDS (2 * QUELL_SCALED)
// Rows of QUELL_LANES pixels of a tile, in the order in which they are added.
#define TILE_VECTORS (TILE_PIXELS / QUELL_LANES)

typedef struct Tile {
  int x;  // of its first pixel
  int y;
} Tile;

// Pixels number vector * QUELL_LANES and following of a tile; `inside` marks those that count.
QUELL_INLINE GatherPlan planTilePixels(PlaneParams planes, Tile tile, int vector, intL* inside) {
  const int pixel = vector * QUELL_LANES;
#if GRAM_MIRROR
  *inside = LANE_INDEX == LANE_INDEX;
  return planBlockRow(planes, pixel, tile.x, tile.y);
#else
  const intL number = pixel + LANE_INDEX;
  const intL x = tile.x + (number & (GRAM_TILE_EDGE - 1));
  const intL y = tile.y + number / GRAM_TILE_EDGE;
  *inside = x >= 0 && x < planes.width && y >= 0 && y < planes.height;
  const intL row = maxLanesInt(minLanesInt(y, (intL)(planes.height - 1)), (intL)(0));
  const intL column = maxLanesInt(minLanesInt(x, (intL)(planes.width - 1)), (intL)(0));
  return planGather((row + QUELL_PLANE_MARGIN_ROWS) * planes.pitch + QUELL_PLANE_MARGIN + column);
#endif
}

QUELL_INLINE floatL tileWeight(__global const float* guides, PlaneParams planes, GatherPlan plan,
                               intL inside) {
  const floatL weight = gatherLanes(guides + (QUELL_GUIDE_WEIGHT + QUELL_SIGNAL) * planes.stride, plan);
  return inside ? weight : ZERO_LANES;
}

// Planes that a tile is made of.
typedef struct Inputs {
  __global const float* irradiance;
  __global const float* guides;
  __global const float* materials;
  PlaneParams planes;
  float4 viewAxis;
} Inputs;

#if QUELL_SCALED > 0
// Lowers `bounds` to the minima of the unbounded variables v, and of -v, over the pixels with a weight.
QUELL_INLINE void includeRange(Inputs inputs, GatherPlan plan, floatL weight, floatL* bounds) {
  floatL scaled[QUELL_SCALED_SLOTS];
  makeScaled(scaled, gatherGuide(inputs.guides, inputs.materials, inputs.planes, plan), inputs.viewAxis);
  for (int k = 0; k < QUELL_SCALED; ++k) {
    const floatL v = scaled[k];
    bounds[k] = weight > 0.0f && v < bounds[k] ? v : bounds[k];
    bounds[k + QUELL_SCALED] = weight > 0.0f && -v < bounds[k + QUELL_SCALED] ? -v : bounds[k + QUELL_SCALED];
  }
}
#endif

// Weighted row of [features | colour].
QUELL_INLINE void makeColumns(Inputs inputs, GatherPlan plan, floatL weight, const float* anchor,
                              const float* scale, floatL* columns) {
  const Guide guide = gatherGuide(inputs.guides, inputs.materials, inputs.planes, plan);
  makeFeatures(columns, guide, inputs.viewAxis, anchor, scale);
  const float3L color =
      gatherLanes3(inputs.irradiance + 3 * QUELL_SIGNAL * inputs.planes.stride, plan, inputs.planes.stride);
  columns[QUELL_GRAM_FEATURES] = color.x;
  columns[QUELL_GRAM_FEATURES + 1] = color.y;
  columns[QUELL_GRAM_FEATURES + 2] = color.z;
  const floatL rootWeight = SQRT(weight);
  // A pixel without weight may lie anywhere, so its features are dropped, not multiplied by zero.
  for (int k = 0; k < QUELL_GRAM_COLUMNS; ++k)
    columns[k] = weight > 0.0f ? columns[k] * rootWeight : ZERO_LANES;
}

QUELL_INLINE void storeRange(__global float* tiles, int tileStride, int tile, const float* low,
                             const float* high) {
  for (int k = 0; k < QUELL_SCALED; ++k) {
    tiles[(QUELL_GRAM_LOW + k) * tileStride + tile] = low[k];
    tiles[(QUELL_GRAM_HIGH + k) * tileStride + tile] = high[k];
  }
}

#if GRAM_GROUP_SIZE == 1

// All products of two columns, written out: loops over them are left rolled by some compilers, which then cannot keep
// columns in registers (2.5 times as long on PoCL).
// Columns that a configuration lacks are compiled out.
#define PRODUCT(a, b) \
  if (b < QUELL_GRAM_COLUMNS) sums[QUELL_GRAM_INDEX(a, b)] += first[a] * first[b] + second[a] * second[b];
#define ROW_FROM_26(a) PRODUCT(a, 26)
#define ROW_FROM_25(a) PRODUCT(a, 25) ROW_FROM_26(a)
#define ROW_FROM_24(a) PRODUCT(a, 24) ROW_FROM_25(a)
#define ROW_FROM_23(a) PRODUCT(a, 23) ROW_FROM_24(a)
#define ROW_FROM_22(a) PRODUCT(a, 22) ROW_FROM_23(a)
#define ROW_FROM_21(a) PRODUCT(a, 21) ROW_FROM_22(a)
#define ROW_FROM_20(a) PRODUCT(a, 20) ROW_FROM_21(a)
#define ROW_FROM_19(a) PRODUCT(a, 19) ROW_FROM_20(a)
#define ROW_FROM_18(a) PRODUCT(a, 18) ROW_FROM_19(a)
#define ROW_FROM_17(a) PRODUCT(a, 17) ROW_FROM_18(a)
#define ROW_FROM_16(a) PRODUCT(a, 16) ROW_FROM_17(a)
#define ROW_FROM_15(a) PRODUCT(a, 15) ROW_FROM_16(a)
#define ROW_FROM_14(a) PRODUCT(a, 14) ROW_FROM_15(a)
#define ROW_FROM_13(a) PRODUCT(a, 13) ROW_FROM_14(a)
#define ROW_FROM_12(a) PRODUCT(a, 12) ROW_FROM_13(a)
#define ROW_FROM_11(a) PRODUCT(a, 11) ROW_FROM_12(a)
#define ROW_FROM_10(a) PRODUCT(a, 10) ROW_FROM_11(a)
#define ROW_FROM_9(a) PRODUCT(a, 9) ROW_FROM_10(a)
#define ROW_FROM_8(a) PRODUCT(a, 8) ROW_FROM_9(a)
#define ROW_FROM_7(a) PRODUCT(a, 7) ROW_FROM_8(a)
#define ROW_FROM_6(a) PRODUCT(a, 6) ROW_FROM_7(a)
#define ROW_FROM_5(a) PRODUCT(a, 5) ROW_FROM_6(a)
#define ROW_FROM_4(a) PRODUCT(a, 4) ROW_FROM_5(a)
#define ROW_FROM_3(a) PRODUCT(a, 3) ROW_FROM_4(a)
#define ROW_FROM_2(a) PRODUCT(a, 2) ROW_FROM_3(a)
#define ROW_FROM_1(a) PRODUCT(a, 1) ROW_FROM_2(a)
#define ROW_FROM_0(a) PRODUCT(a, 0) ROW_FROM_1(a)
// clang-format off
#define ALL_PRODUCTS                                                                                \
  ROW_FROM_0(0) ROW_FROM_1(1) ROW_FROM_2(2) ROW_FROM_3(3) ROW_FROM_4(4) ROW_FROM_5(5) ROW_FROM_6(6) \
  ROW_FROM_7(7) ROW_FROM_8(8) ROW_FROM_9(9) ROW_FROM_10(10) ROW_FROM_11(11) ROW_FROM_12(12)         \
  ROW_FROM_13(13) ROW_FROM_14(14) ROW_FROM_15(15) ROW_FROM_16(16) ROW_FROM_17(17) ROW_FROM_18(18)   \
  ROW_FROM_19(19) ROW_FROM_20(20) ROW_FROM_21(21) ROW_FROM_22(22) ROW_FROM_23(23) ROW_FROM_24(24)   \
  ROW_FROM_25(25) ROW_FROM_26(26)
// clang-format on
#if QUELL_GRAM_FEATURES > QUELL_MOST_GRAM_FEATURES
#error "ALL_PRODUCTS is written for 27 columns"
#endif

__kernel void gram_sums(__global const float* irradiance, __global const float* guides,
                        __global const float* materials, __global float* tiles, GramParams params) {
  const int number = (int)get_global_id(0);
  if (number >= params.tilesX * params.tilesY) return;
  const PlaneParams planes = params.planes;
  const Tile tile = {params.tileOffsetX + (number % params.tilesX) * GRAM_TILE_EDGE,
                     params.tileOffsetY + (number / params.tilesX) * GRAM_TILE_EDGE};
  const Inputs inputs = {irradiance, guides, materials, planes, params.viewAxis};
  intL inside;

  float low[QUELL_SCALED_SLOTS], high[QUELL_SCALED_SLOTS];
  float anchor[QUELL_SCALED_SLOTS], scale[QUELL_SCALED_SLOTS];
#if QUELL_SCALED > 0
  floatL bounds[BOUNDS];
  for (int k = 0; k < BOUNDS; ++k) bounds[k] = (floatL)(NO_POSITION);
  for (int vector = 0; vector < TILE_VECTORS; ++vector) {
    const GatherPlan plan = planTilePixels(planes, tile, vector, &inside);
    includeRange(inputs, plan, tileWeight(guides, planes, plan, inside), bounds);
  }
  for (int k = 0; k < QUELL_SCALED; ++k) {
    low[k] = minOfLanes(bounds[k]);
    high[k] = -minOfLanes(bounds[k + QUELL_SCALED]);
  }
  scaleRanges(low, high, anchor, scale);
#endif

  // Two vectors a turn halve the traffic of the sums, which do not fit into registers.
  floatL sums[QUELL_GRAM_SUMS];
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) sums[k] = ZERO_LANES;
  for (int vector = 0; vector < TILE_VECTORS; vector += 2) {
    floatL first[QUELL_GRAM_COLUMNS], second[QUELL_GRAM_COLUMNS];
    const GatherPlan firstPlan = planTilePixels(planes, tile, vector, &inside);
    makeColumns(inputs, firstPlan, tileWeight(guides, planes, firstPlan, inside), anchor, scale, first);
    const GatherPlan secondPlan = planTilePixels(planes, tile, vector + 1, &inside);
    makeColumns(inputs, secondPlan, tileWeight(guides, planes, secondPlan, inside), anchor, scale, second);
    ALL_PRODUCTS
  }
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) tiles[k * params.tileStride + number] = sumLanes(sums[k]);
  storeRange(tiles, params.tileStride, number, low, high);
}

#else

// Pixels staged at once: 27 columns of 64 floats take 6.8 KiB of local memory.
#define STAGED_PIXELS 64
// Products added in one go; then sums of sums. One chain of a thousand terms loses 1e-5 of them, more than the
// regularisation hides: predictions of a few odd pixels were off by up to 3 %.
#define RUN_PIXELS 16
// Sums that one work-item owns.
#define ITEM_SUMS ((QUELL_GRAM_SUMS + GRAM_GROUP_SIZE - 1) / GRAM_GROUP_SIZE)

__kernel __attribute__((reqd_work_group_size(GRAM_GROUP_SIZE, 1, 1))) void gram_sums(
    __global const float* irradiance, __global const float* guides, __global const float* materials,
    __global float* tiles, GramParams params) {
  const int id = (int)get_local_id(0);
  const int number = (int)get_group_id(0);
  const PlaneParams planes = params.planes;
  const Tile tile = {params.tileOffsetX + (number % params.tilesX) * GRAM_TILE_EDGE,
                     params.tileOffsetY + (number / params.tilesX) * GRAM_TILE_EDGE};
  const Inputs inputs = {irradiance, guides, materials, planes, params.viewAxis};
  __local float staged[STAGED_PIXELS * QUELL_GRAM_COLUMNS];
  int inside;

  float low[QUELL_SCALED_SLOTS], high[QUELL_SCALED_SLOTS];
  float anchor[QUELL_SCALED_SLOTS], scale[QUELL_SCALED_SLOTS];
#if QUELL_SCALED > 0
  __local float ranges[BOUNDS * GRAM_GROUP_SIZE];
  float bounds[BOUNDS];
  for (int k = 0; k < BOUNDS; ++k) bounds[k] = NO_POSITION;
  for (int pixel = id; pixel < TILE_PIXELS; pixel += GRAM_GROUP_SIZE) {
    const GatherPlan plan = planTilePixels(planes, tile, pixel, &inside);
    includeRange(inputs, plan, tileWeight(guides, planes, plan, inside), bounds);
  }
  for (int k = 0; k < BOUNDS; ++k) ranges[k * GRAM_GROUP_SIZE + id] = bounds[k];
  barrier(CLK_LOCAL_MEM_FENCE);
  for (int active = GRAM_GROUP_SIZE / 2; active > 0; active /= 2) {
    if (id < active) {
      for (int k = 0; k < BOUNDS; ++k)
        ranges[k * GRAM_GROUP_SIZE + id] =
            minLanes(ranges[k * GRAM_GROUP_SIZE + id], ranges[k * GRAM_GROUP_SIZE + id + active]);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  for (int k = 0; k < QUELL_SCALED; ++k) {
    low[k] = ranges[k * GRAM_GROUP_SIZE];
    high[k] = -ranges[(k + QUELL_SCALED) * GRAM_GROUP_SIZE];
  }
  scaleRanges(low, high, anchor, scale);
#endif

  // Which columns this work-item multiplies for each of its sums.
  int columnA[ITEM_SUMS], columnB[ITEM_SUMS];
  float sums[ITEM_SUMS];
  for (int k = 0; k < ITEM_SUMS; ++k) {
    int rest = id + k * GRAM_GROUP_SIZE;
    int a = 0;
    for (int row = 0; row < QUELL_GRAM_COLUMNS - 1; ++row) {
      const int length = QUELL_GRAM_COLUMNS - row;
      const int further = a == row && rest >= length;
      rest -= further ? length : 0;
      a += further ? 1 : 0;
    }
    columnA[k] = a;
    columnB[k] = min(a + rest, QUELL_GRAM_COLUMNS - 1);
    sums[k] = 0.0f;
  }

  for (int first = 0; first < TILE_PIXELS; first += STAGED_PIXELS) {
    for (int pixel = id; pixel < STAGED_PIXELS; pixel += GRAM_GROUP_SIZE) {
      const GatherPlan plan = planTilePixels(planes, tile, first + pixel, &inside);
      float columns[QUELL_GRAM_COLUMNS];
      makeColumns(inputs, plan, tileWeight(guides, planes, plan, inside), anchor, scale, columns);
      for (int k = 0; k < QUELL_GRAM_COLUMNS; ++k) staged[pixel * QUELL_GRAM_COLUMNS + k] = columns[k];
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    float stagedSums[ITEM_SUMS];
    for (int k = 0; k < ITEM_SUMS; ++k) stagedSums[k] = 0.0f;
      // Unrolled further, loads are moved ahead until registers run out: 256 of them and spills on GCN instead of 25.
#pragma unroll 1
    for (int run = 0; run < STAGED_PIXELS; run += RUN_PIXELS) {
      float runSums[ITEM_SUMS];
      for (int k = 0; k < ITEM_SUMS; ++k) runSums[k] = 0.0f;
#pragma unroll 4
      for (int pixel = run; pixel < run + RUN_PIXELS; ++pixel) {
        for (int k = 0; k < ITEM_SUMS; ++k)
          runSums[k] += staged[pixel * QUELL_GRAM_COLUMNS + columnA[k]] *
                        staged[pixel * QUELL_GRAM_COLUMNS + columnB[k]];
      }
      for (int k = 0; k < ITEM_SUMS; ++k) stagedSums[k] += runSums[k];
    }
    for (int k = 0; k < ITEM_SUMS; ++k) sums[k] += stagedSums[k];
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  for (int k = 0; k < ITEM_SUMS; ++k) {
    if (id + k * GRAM_GROUP_SIZE < QUELL_GRAM_SUMS)
      tiles[(id + k * GRAM_GROUP_SIZE) * params.tileStride + number] = sums[k];
  }
  if (id == 0) storeRange(tiles, params.tileStride, number, low, high);
}

#endif

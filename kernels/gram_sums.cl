// gram_sums: sums over a tile of all products of features and colours: everything a least-squares fit needs.
// Paper:   the normal equations of Koskela et al. 2019, eq. (2); the features of its eq. (1) as in fit.cl.
// In:      irradiance (3 planes per signal, of which those of QUELL_SIGNAL are fitted) and guides (see
//          common/guides.h) of this frame; materials (4 planes) where a feature needs them; with TAP_WEIGHTS the
//          weights of pixels, instead of those of the guides.
// Out:     per tile the upper triangle of the weighted Gram matrix of [features | colour] and the range of the
//          unbounded variables, one plane per number (gram_params.h); they are scaled to [0, 1] by it, as in fit.cl.
// Tiles:   GRAM_TILE_EDGE pixels square. With GRAM_MIRROR pixels outside the image are mirrored (blocks of 32, as in
//          fit.cl), else they are left out.
// Why:     the factorisation in fit.cl makes 85 passes over columns of 1024 numbers; this is one pass over the pixels.
//
// GROUP_SIZE 1: one work-item a tile, sixteen pixels at once, all sums (91 of ten features) held by it. Above: the
// work-group stages columns in local memory and every work-item owns some of the sums. Both add in one fixed order.
#include "common/blocks.h"
#include "common/fit_features.h"
#include "common/fit_inputs.h"
#include "common/planes.h"
#include "gram_sums_ports.h"

#define TILE_PIXELS (GRAM_TILE_EDGE * GRAM_TILE_EDGE)

// Rows of QUELL_LANES pixels of a tile, in the order in which they are added.
#define TILE_VECTORS (TILE_PIXELS / QUELL_LANES)

typedef struct Tile {
  int x;  // of its first pixel
  int y;
} Tile;

QUELL_INLINE Tile tileOf(GramParams params, int number) {
  const Tile tile = {params.tileOffsetX + (number % params.tilesX) * GRAM_TILE_EDGE,
                     params.tileOffsetY + (number / params.tilesX) * GRAM_TILE_EDGE};
  return tile;
}

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
  *inside = insideFrame(planes, x, y);
  const intL row = maxLanesInt(minLanesInt(y, (intL)(planes.height - 1)), (intL)(0));
  const intL column = maxLanesInt(minLanesInt(x, (intL)(planes.width - 1)), (intL)(0));
  return planGather(planeIndexOfLanes(planes, column, row));
#endif
}

QUELL_INLINE floatL tileWeight(FitInputs inputs, GatherPlan plan, intL inside) {
  return inside ? gatherWeight(inputs, plan) : ZERO_LANES;
}

// Ranges and scaling of the unbounded variables of a tile.
typedef struct TileRange {
  float low[QUELL_SCALED_SLOTS];
  float high[QUELL_SCALED_SLOTS];
  float anchor[QUELL_SCALED_SLOTS];
  float scale[QUELL_SCALED_SLOTS];
} TileRange;

QUELL_INLINE void findRange(FitInputs inputs, Tile tile, int id, __local floatL* exchange, TileRange* range) {
#if QUELL_SCALED > 0
  floatL bounds[BOUNDS];
  beginRange(bounds);
  for (int vector = id; vector < TILE_VECTORS; vector += GROUP_SIZE) {
    intL inside;
    const GatherPlan plan = planTilePixels(inputs.planes, tile, vector, &inside);
    includeRange(inputs, plan, tileWeight(inputs, plan, inside), bounds);
  }
  groupMin(exchange, id, bounds);
  endRange(bounds, range->low, range->high);
  scaleRanges(range->low, range->high, range->anchor, range->scale);
#endif
}

// Weighted rows of [features | colour] of QUELL_LANES pixels.
QUELL_INLINE void makeColumns(FitInputs inputs, Tile tile, int vector, const TileRange* range,
                              floatL* columns) {
  intL inside;
  const GatherPlan plan = planTilePixels(inputs.planes, tile, vector, &inside);
  const floatL weight = tileWeight(inputs, plan, inside);
  makeFeatures(columns, gatherInputs(inputs, plan), inputs.viewAxis, range->anchor, range->scale);
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

QUELL_INLINE void storeRange(__global float* tiles, int tileStride, int tile, const TileRange* range) {
  for (int k = 0; k < QUELL_SCALED; ++k) {
    tiles[(QUELL_GRAM_LOW + k) * tileStride + tile] = range->low[k];
    tiles[(QUELL_GRAM_HIGH + k) * tileStride + tile] = range->high[k];
  }
}

#if GROUP_SIZE == 1

// Whether there is a surface in a tile; what is mirrored into it counts.
QUELL_INLINE int anySurfaceInTile(__global const uchar* surfaces, PlaneParams planes, Tile tile) {
#if GRAM_MIRROR
  return anySurfaceInBlock(surfaces, planes, tile.x, tile.y, GRAM_TILE_EDGE);
#else
  return anySurface(surfaces, planes, tile.x, tile.y, tile.x + GRAM_TILE_EDGE - 1,
                    tile.y + GRAM_TILE_EDGE - 1);
#endif
}

// Sums and ranges of no pixels.
QUELL_INLINE void storeEmptyTile(__global float* tiles, int tileStride, int tile) {
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) tiles[k * tileStride + tile] = 0.0f;
  for (int k = 0; k < QUELL_SCALED; ++k) {
    tiles[(QUELL_GRAM_LOW + k) * tileStride + tile] = NO_POSITION;
    tiles[(QUELL_GRAM_HIGH + k) * tileStride + tile] = -NO_POSITION;
  }
}

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

__kernel void gram_sums(STAGE_ARGUMENTS(GRAM_SUMS) GramParams params) {
  const int number = (int)get_global_id(0);
  if (number >= params.tilesX * params.tilesY) return;
  const Tile tile = tileOf(params, number);
  // A work-group would have to agree on this before a barrier; one work-item does not.
  if (SKIP && !anySurfaceInTile(surfaces, params.planes, tile)) {
    storeEmptyTile(gramTiles, params.tileStride, number);
    return;
  }
  const FitInputs inputs = FIT_INPUTS(params);
  TileRange range;
  findRange(inputs, tile, 0, 0, &range);

  // Two vectors a turn halve the traffic of the sums, which do not fit into registers.
  floatL sums[QUELL_GRAM_SUMS];
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) sums[k] = ZERO_LANES;
  for (int vector = 0; vector < TILE_VECTORS; vector += 2) {
    floatL first[QUELL_GRAM_COLUMNS], second[QUELL_GRAM_COLUMNS];
    makeColumns(inputs, tile, vector, &range, first);
    makeColumns(inputs, tile, vector + 1, &range, second);
    ALL_PRODUCTS
  }
  for (int k = 0; k < QUELL_GRAM_SUMS; ++k) gramTiles[k * params.tileStride + number] = sumLanes(sums[k]);
  storeRange(gramTiles, params.tileStride, number, &range);
}

#else

// Pixels staged at once: 27 columns of 64 floats take 6.8 KiB of local memory.
#define STAGED_PIXELS 64
// Products added in one go; then sums of sums. One chain of a thousand terms loses 1e-5 of them, more than the
// regularisation hides: predictions of a few odd pixels were off by up to 3 %.
#define RUN_PIXELS 16
// Sums that one work-item owns.
#define ITEM_SUMS ((QUELL_GRAM_SUMS + GROUP_SIZE - 1) / GROUP_SIZE)

// Which two columns this work-item multiplies for each of its sums.
QUELL_INLINE void assignSums(int id, int* columnA, int* columnB) {
  for (int k = 0; k < ITEM_SUMS; ++k) {
    int rest = id + k * GROUP_SIZE;
    int a = 0;
    for (int row = 0; row < QUELL_GRAM_COLUMNS - 1; ++row) {
      const int length = QUELL_GRAM_COLUMNS - row;
      const int further = a == row && rest >= length;
      rest -= further ? length : 0;
      a += further ? 1 : 0;
    }
    columnA[k] = a;
    columnB[k] = min(a + rest, QUELL_GRAM_COLUMNS - 1);
  }
}

// Columns of STAGED_PIXELS pixels from `first` on, for the work-group.
QUELL_INLINE void stageColumns(FitInputs inputs, Tile tile, int first, int id, const TileRange* range,
                               __local float* staged) {
  for (int pixel = id; pixel < STAGED_PIXELS; pixel += GROUP_SIZE) {
    float columns[QUELL_GRAM_COLUMNS];
    makeColumns(inputs, tile, first + pixel, range, columns);
    for (int k = 0; k < QUELL_GRAM_COLUMNS; ++k) staged[pixel * QUELL_GRAM_COLUMNS + k] = columns[k];
  }
}

// Adds the products of what is staged to the sums of this work-item.
QUELL_INLINE void addStaged(__local const float* staged, const int* columnA, const int* columnB,
                            float* sums) {
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
        runSums[k] +=
            staged[pixel * QUELL_GRAM_COLUMNS + columnA[k]] * staged[pixel * QUELL_GRAM_COLUMNS + columnB[k]];
    }
    for (int k = 0; k < ITEM_SUMS; ++k) stagedSums[k] += runSums[k];
  }
  for (int k = 0; k < ITEM_SUMS; ++k) sums[k] += stagedSums[k];
}

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void gram_sums(STAGE_ARGUMENTS(GRAM_SUMS)
                                                                                    GramParams params) {
  const int id = (int)get_local_id(0);
  const int number = (int)get_group_id(0);
  const Tile tile = tileOf(params, number);
  const FitInputs inputs = FIT_INPUTS(params);
  __local float exchange[BOUNDS > 0 ? BOUNDS * GROUP_SIZE : 1];
  __local float staged[STAGED_PIXELS * QUELL_GRAM_COLUMNS];

  TileRange range;
  findRange(inputs, tile, id, exchange, &range);
  int columnA[ITEM_SUMS], columnB[ITEM_SUMS];
  assignSums(id, columnA, columnB);
  float sums[ITEM_SUMS];
  for (int k = 0; k < ITEM_SUMS; ++k) sums[k] = 0.0f;
  for (int first = 0; first < TILE_PIXELS; first += STAGED_PIXELS) {
    stageColumns(inputs, tile, first, id, &range, staged);
    barrier(CLK_LOCAL_MEM_FENCE);
    addStaged(staged, columnA, columnB, sums);
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  for (int k = 0; k < ITEM_SUMS; ++k) {
    if (id + k * GROUP_SIZE < QUELL_GRAM_SUMS)
      gramTiles[(id + k * GROUP_SIZE) * params.tileStride + number] = sums[k];
  }
  if (id == 0) storeRange(gramTiles, params.tileStride, number, &range);
}

#endif

// Blocks and tiles of pixels: where their rows lie, and how their positions are scaled.
#ifndef QUELL_COMMON_BLOCKS_H
#define QUELL_COMMON_BLOCKS_H

#include "common/planes.h"
#include "common/surfaces.h"
#include "fit_params.h"

// Larger than any position; the identity of the minimum.
#define NO_POSITION 3e38f

// Nearest pixel of a mirrored image. Reflections repeat with period 2 * size, which matters where the image is smaller
// than a block.
QUELL_INLINE int mirror(int i, int size) {
  int folded = i % (2 * size);
  folded = folded < 0 ? folded + 2 * size : folded;
  return folded < size ? folded : 2 * size - 1 - folded;
}

// First and last pixel of an image that `edge` pixels from `first` on show, mirrored at the borders.
QUELL_INLINE int firstMirrored(int first, int edge, int size) {
  const int last = first + edge - 1;
  return max(last >= size ? min(first, 2 * size - 1 - last) : first, 0);
}
QUELL_INLINE int lastMirrored(int first, int edge, int size) {
  const int last = first + edge - 1;
  return min(first < 0 ? max(last, -1 - first) : last, size - 1);
}

// Whether a block shows a surface, also in what is mirrored into it.
QUELL_INLINE int anySurfaceInBlock(__global const uchar* surfaces, PlaneParams planes, int x, int y,
                                   int edge) {
  return anySurface(surfaces, planes, firstMirrored(x, edge, planes.width),
                    firstMirrored(y, edge, planes.height), lastMirrored(x, edge, planes.width),
                    lastMirrored(y, edge, planes.height));
}

QUELL_INLINE GatherPlan planBlockRow(PlaneParams planes, int row, int blockX, int blockY) {
  const int x = blockX + (row & (QUELL_BLOCK_EDGE - 1));
  int y = blockY + row / QUELL_BLOCK_EDGE;
  if (y < 0 || y >= planes.height) y = mirror(y, planes.height);
  GatherPlan plan;
#if QUELL_LANES == 1
  plan.index = planeIndex(planes, mirror(x, planes.width), y);
#else
  if (x >= 0 && x + QUELL_LANES <= planes.width) {
    plan.index = planeIndex(planes, x, y) + LANE_INDEX;
    plan.firstRun = planeIndex(planes, x, y);
    plan.lastRun = plan.firstRun;
    plan.inFirstRun = (intL)(-1);
    plan.runs = 1;
  } else {
    int columns[QUELL_LANES];
    for (int lane = 0; lane < QUELL_LANES; ++lane) columns[lane] = mirror(x + lane, planes.width);
    plan = planGather(planeIndex(planes, 0, y) + LOAD_VECTOR(columns));
  }
#endif
  return plan;
}

// OP of all lanes, by halves.
#if QUELL_LANES == 16
#define REDUCE_LANES(v, OP)            \
  const float8 a = OP((v).lo, (v).hi); \
  const float4 b = OP(a.lo, a.hi);     \
  const float2 c = OP(b.lo, b.hi);     \
  return OP(c.x, c.y);
#elif QUELL_LANES == 8
#define REDUCE_LANES(v, OP)            \
  const float4 b = OP((v).lo, (v).hi); \
  const float2 c = OP(b.lo, b.hi);     \
  return OP(c.x, c.y);
#elif QUELL_LANES == 4
#define REDUCE_LANES(v, OP)            \
  const float2 c = OP((v).lo, (v).hi); \
  return OP(c.x, c.y);
#else
#define REDUCE_LANES(v, OP) return v;
#endif
#define SUM_OF(a, b) ((a) + (b))
#define LEAST_OF(a, b) ((a) < (b) ? (a) : (b))

QUELL_INLINE float sumLanes(floatL v){REDUCE_LANES(v, SUM_OF)} QUELL_INLINE
    float minOfLanes(floatL v){REDUCE_LANES(v, LEAST_OF)}
// Scaling of a set of pixels from the ranges of its variables: (v - anchor) * scale lies in [0, 1]. A range that is
// rounding noise next to the view distance (SIZE: of this variable, in its unit) is divided by the distance instead,
// which leaves it below 1e-4 and drowned by the injected noise. An empty set (low > high) gets anchor 0 and scale 1.
// Once for one set and once for a set per lane.
#define QUELL_SCALED_SLOTS (QUELL_SCALED > 0 ? QUELL_SCALED : 1)
#ifndef QUELL_SIZE_LIST
#define QUELL_SIZE_LIST
#endif
#define SIZE(k, size)                                                         \
  {                                                                           \
    const RANGE_TYPE least = QUELL_FIT_LEAST_RANGE * (size);                  \
    const RANGE_TYPE otherwise = (size) > 0.0f ? (size) : (RANGE_TYPE)(1.0f); \
    anchor[k] = low[k] > high[k] ? (RANGE_TYPE)(0.0f) : low[k];               \
    scale[k] = low[k] > high[k] ? (RANGE_TYPE)(0.0f) : high[k] - low[k];      \
    scale[k] = 1.0f / (scale[k] > least ? scale[k] : otherwise);              \
  }
#if QUELL_SCALED_POSITIONS
#define SCALE_POSITIONS                                                             \
  RANGE_TYPE centreSquared = (RANGE_TYPE)(0.0f);                                    \
  for (int axis = 0; axis < 3; ++axis) {                                            \
    const RANGE_TYPE centre = 0.5f * low[axis] + 0.5f * high[axis];                 \
    centreSquared += low[axis] > high[axis] ? (RANGE_TYPE)(0.0f) : centre * centre; \
  }                                                                                 \
  const RANGE_TYPE distance = sqrt(centreSquared);                                  \
  for (int axis = 0; axis < 3; ++axis) SIZE(axis, distance)
#else
#define SCALE_POSITIONS
#endif

#define RANGE_TYPE float
QUELL_INLINE void scaleRanges(const float* low, const float* high, float* anchor,
                              float* scale){SCALE_POSITIONS QUELL_SIZE_LIST}
#undef RANGE_TYPE
#if QUELL_LANES > 1
#define RANGE_TYPE floatL
QUELL_INLINE void scaleRangesLanes(const floatL* low, const floatL* high, floatL* anchor, floatL* scale) {
  SCALE_POSITIONS
  QUELL_SIZE_LIST
}
#undef RANGE_TYPE
#else
#define scaleRangesLanes scaleRanges
#endif

#endif

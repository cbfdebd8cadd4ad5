// Quell's own planes: loads, stores and gathers of QUELL_LANES pixels. See PlaneParams in types.h.
#ifndef QUELL_COMMON_PLANES_H
#define QUELL_COMMON_PLANES_H

#include "common/lanes.h"
#include "common/types.h"

// Element of pixel (x, y) within a plane; x from -QUELL_PLANE_MARGIN to width, y from -1 to height.
QUELL_INLINE int planeIndex(PlaneParams planes, int x, int y) {
  return (y + QUELL_PLANE_MARGIN_ROWS) * planes.pitch + QUELL_PLANE_MARGIN + x;
}

// The same of a pixel per lane.
QUELL_INLINE intL planeIndexOfLanes(PlaneParams planes, intL column, intL row) {
  return (row + QUELL_PLANE_MARGIN_ROWS) * planes.pitch + QUELL_PLANE_MARGIN + column;
}

// Whether pixels lie in the frame.
QUELL_INLINE intL insideColumns(PlaneParams planes, intL column) {
  return column >= 0 && column < planes.width;
}
QUELL_INLINE intL insideFrame(PlaneParams planes, intL column, intL row) {
  return insideColumns(planes, column) && row >= 0 && row < planes.height;
}

// Whether pixels at indices (x, y) would cover a part of the frame.
QUELL_INLINE intL touchesFrame(floatL x, floatL y, int width, int height) {
  return x > -1.0f && x < (float)width && y > -1.0f && y < (float)height;
}

// Begins a kernel whose work-items take QUELL_LANES pixels of a row each: declares planes, stride, x, y and index, the
// element of the first pixel, and returns where there is no pixel.
#define BEGIN_PIXELS(planeParams)                      \
  const PlaneParams planes = (planeParams);            \
  const int stride = planes.stride;                    \
  const int x = (int)get_global_id(0) * QUELL_LANES;   \
  const int y = (int)get_global_id(1);                 \
  if (x >= planes.width || y >= planes.height) return; \
  const int index = planeIndex(planes, x, y);          \
  (void)stride, (void)index /* not all kernels want both */

QUELL_INLINE floatL loadLanes(__global const float* plane) {
#if QUELL_LANES == 1
  return plane[0];
#else
  return LOAD_GLOBAL(float, plane);
#endif
}

QUELL_INLINE void storeLanes(floatL value, __global float* plane) {
#if QUELL_LANES == 1
  plane[0] = value;
#else
  STORE_GLOBAL(float, value, plane);
#endif
}

QUELL_INLINE void storeIntLanes(intL value, __global int* plane) {
#if QUELL_LANES == 1
  plane[0] = value;
#else
  STORE_GLOBAL(int, value, plane);
#endif
}

QUELL_INLINE intL loadByteLanes(__global const uchar* plane) {
#if QUELL_LANES == 1
  return plane[0];
#else
  return TO_INT(LOAD_GLOBAL(uchar, plane));
#endif
}

// Values must be in [0, 255].
QUELL_INLINE void storeByteLanes(intL value, __global uchar* plane) {
#if QUELL_LANES == 1
  plane[0] = (uchar)value;
#else
  STORE_GLOBAL(uchar, TO_UCHAR(value), plane);
#endif
}

QUELL_INLINE float3L loadLanes3(__global const float* planes, int index, int stride) {
  float3L result;
  result.x = loadLanes(planes + index);
  result.y = loadLanes(planes + index + stride);
  result.z = loadLanes(planes + index + 2 * stride);
  return result;
}

QUELL_INLINE void storeLanes3(float3L value, __global float* planes, int index, int stride) {
  storeLanes(value.x, planes + index);
  storeLanes(value.y, planes + index + stride);
  storeLanes(value.z, planes + index + 2 * stride);
}

// How to fetch one element per lane from arbitrary places. Reprojection is smooth, so the places of
// neighbours nearly always form one run of consecutive elements, or two where the motion crosses a pixel boundary or
// a silhouette; then one or two vector loads replace as many scalar ones as there are lanes.
typedef struct GatherPlan {
  intL index;
#if QUELL_LANES > 1
  intL inFirstRun;
  int firstRun;  // element that lane 0 of the first run reads
  int lastRun;   // element that lane 0 of the last run would read
  int runs;      // 1 or 2: vector loads; 0: scattered
#endif
} GatherPlan;

QUELL_INLINE GatherPlan planGather(intL index) {
  GatherPlan plan;
  plan.index = index;
#if QUELL_LANES > 1
  plan.firstRun = index.s0;
  plan.lastRun = LAST_LANE(index) - (QUELL_LANES - 1);
  plan.inFirstRun = index == plan.firstRun + LANE_INDEX;
  const intL inLastRun = index == plan.lastRun + LANE_INDEX;
  plan.runs = all(plan.inFirstRun) ? 1 : all(plan.inFirstRun || inLastRun) ? 2 : 0;
#endif
  return plan;
}

// Whether a plan is the usual one: then code that gathers much by it is worth writing twice, once with oneRun(), whose
// loads need no further question. With a single lane every plan is.
QUELL_INLINE int isOneRun(GatherPlan plan) {
#if QUELL_LANES == 1
  return 1;
#else
  return plan.runs == 1;
#endif
}

// The same plan, for a compiler that cannot tell by itself.
QUELL_INLINE GatherPlan oneRun(GatherPlan plan) {
#if QUELL_LANES > 1
  plan.runs = 1;
#endif
  return plan;
}

// Element of one lane.
#define GATHERED(i) plane[at.s##i]

QUELL_INLINE floatL gatherLanes(__global const float* plane, GatherPlan plan) {
#if QUELL_LANES == 1
  return plane[plan.index];
#else
  if (plan.runs == 1) return LOAD_GLOBAL(float, plane + plan.firstRun);
  if (plan.runs == 2)
    return plan.inFirstRun ? LOAD_GLOBAL(float, plane + plan.firstRun)
                           : LOAD_GLOBAL(float, plane + plan.lastRun);
  const intL at = plan.index;
  return (floatL)(EACH_LANE(GATHERED));
#endif
}

QUELL_INLINE intL gatherIntLanes(__global const int* plane, GatherPlan plan) {
#if QUELL_LANES == 1
  return plane[plan.index];
#else
  if (plan.runs == 1) return LOAD_GLOBAL(int, plane + plan.firstRun);
  if (plan.runs == 2)
    return plan.inFirstRun ? LOAD_GLOBAL(int, plane + plan.firstRun) : LOAD_GLOBAL(int, plane + plan.lastRun);
  const intL at = plan.index;
  return (intL)(EACH_LANE(GATHERED));
#endif
}

QUELL_INLINE floatL gatherByteLanes(__global const uchar* plane, GatherPlan plan) {
#if QUELL_LANES == 1
  return TO_FLOAT(plane[plan.index]);
#else
  if (plan.runs == 1) return TO_FLOAT(LOAD_GLOBAL(uchar, plane + plan.firstRun));
  if (plan.runs == 2) {
    const floatL first = TO_FLOAT(LOAD_GLOBAL(uchar, plane + plan.firstRun));
    return plan.inFirstRun ? first : TO_FLOAT(LOAD_GLOBAL(uchar, plane + plan.lastRun));
  }
  const intL at = plan.index;
  return (floatL)(EACH_LANE(GATHERED));
#endif
}

QUELL_INLINE float3L gatherLanes3(__global const float* planes, GatherPlan plan, int stride) {
  float3L result;
  result.x = gatherLanes(planes, plan);
  result.y = gatherLanes(planes + stride, plan);
  result.z = gatherLanes(planes + 2 * stride, plan);
  return result;
}

#endif

// The pixels that a fit is made of, their weights, and the ranges of their unbounded variables over a block or tile that
// GROUP_SIZE work-items share.
#ifndef QUELL_COMMON_FIT_INPUTS_H
#define QUELL_COMMON_FIT_INPUTS_H

#include "common/blocks.h"
#include "common/fit_features.h"
#include "common/planes.h"

#if GROUP_SIZE == 1
#define GROUP_BARRIER
#else
#define GROUP_BARRIER barrier(CLK_LOCAL_MEM_FENCE)
#endif

// Ends of the ranges: the minima of the variables, then those of the variables negated.
#define BOUNDS (2 * QUELL_SCALED)

typedef struct FitInputs {
  __global const float* irradiance;
  __global const float* guides;
  __global const float* weights;  // of pixels in the fit, one plane
  __global const float* materials;
  PlaneParams planes;
  float4 viewAxis;
} FitInputs;

// Of the kernel's arguments.
#if TAP_WEIGHTS
#define FIT_WEIGHTS(planes) (tapWeights + QUELL_SIGNAL * (planes).stride)
#else
#define FIT_WEIGHTS(planes) (guides + (QUELL_GUIDE_WEIGHT + QUELL_SIGNAL) * (planes).stride)
#endif
#define FIT_INPUTS(params) \
  { irradiance, guides, FIT_WEIGHTS((params).planes), materials, (params).planes, (params).viewAxis }

QUELL_INLINE Guide gatherInputs(FitInputs inputs, GatherPlan plan) {
  return gatherGuide(inputs.guides, inputs.materials, inputs.planes, plan);
}

QUELL_INLINE floatL gatherWeight(FitInputs inputs, GatherPlan plan) {
  return gatherLanes(inputs.weights, plan);
}

#if QUELL_SCALED > 0
QUELL_INLINE void beginRange(floatL* bounds) {
  UNROLL_ON_GPU
  for (int k = 0; k < BOUNDS; ++k) bounds[k] = (floatL)(NO_POSITION);
}

// Takes pixels in that have a weight.
QUELL_INLINE void includeRange(FitInputs inputs, GatherPlan plan, floatL weight, floatL* bounds) {
  floatL scaled[QUELL_SCALED];
  makeScaled(scaled, gatherInputs(inputs, plan), inputs.viewAxis);
  UNROLL_ON_GPU
  for (int k = 0; k < QUELL_SCALED; ++k) {
    const floatL v = scaled[k];
    bounds[k] = weight > 0.0f && v < bounds[k] ? v : bounds[k];
    bounds[k + QUELL_SCALED] = weight > 0.0f && -v < bounds[k + QUELL_SCALED] ? -v : bounds[k + QUELL_SCALED];
  }
}

// Bounds over all work-items of the group, which all get them, in a halving tree.
QUELL_INLINE void groupMin(__local floatL* exchange, int id, floatL* bounds) {
#if GROUP_SIZE > 1
  UNROLL_ON_GPU
  for (int k = 0; k < BOUNDS; ++k) exchange[k * GROUP_SIZE + id] = bounds[k];
  GROUP_BARRIER;
  for (int active = GROUP_SIZE / 2; active > 0; active /= 2) {
    if (id < active) {
      UNROLL_ON_GPU
      for (int k = 0; k < BOUNDS; ++k)
        exchange[k * GROUP_SIZE + id] =
            minLanes(exchange[k * GROUP_SIZE + id], exchange[k * GROUP_SIZE + id + active]);
    }
    GROUP_BARRIER;
  }
  UNROLL_ON_GPU
  for (int k = 0; k < BOUNDS; ++k) bounds[k] = exchange[k * GROUP_SIZE];
  GROUP_BARRIER;
#endif
}

QUELL_INLINE void endRange(const floatL* bounds, float* low, float* high) {
  UNROLL_ON_GPU
  for (int k = 0; k < QUELL_SCALED; ++k) {
    low[k] = minOfLanes(bounds[k]);
    high[k] = -minOfLanes(bounds[k + QUELL_SCALED]);
  }
}
#endif

#endif

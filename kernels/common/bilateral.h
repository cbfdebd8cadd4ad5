// Means over taps that weigh less the less they resemble the centre: what bilateral filters have in common.
#ifndef QUELL_COMMON_BILATERAL_H
#define QUELL_COMMON_BILATERAL_H

#include "common/exponential.h"
#include "common/planes.h"

typedef struct BilateralSums {
  float3L value;
  floatL weight;
} BilateralSums;

// Adds the taps of QUELL_LANES pixels from `column` on, `index` their element; those outside the image or without a sample
// count for nothing. `falloff`: weight by distance. The pointers are those of the signal.
QUELL_INLINE BilateralSums addBilateralTaps(BilateralSums sums, __global const float* values,
                                            __global const float* weights, PlaneParams planes, int column,
                                            int index, floatL penalty, float falloff) {
  const floatL own = loadLanes(weights + index);
  const intL counts = insideColumns(planes, column + LANE_INDEX) && own > 0.0f;
  const floatL weight = counts ? falloff * own * weightOfPenalty(penalty) : ZERO_LANES;
  const float3L weighted = scale3(loadLanes3(values, index, planes.stride), weight);
  sums.value = add3(sums.value, select3(counts, weighted, splat3(0.0f)));
  sums.weight += weight;
  return sums;
}

// 0 without any tap.
QUELL_INLINE float3L bilateralMean(BilateralSums sums) {
  const floatL inverse = sums.weight > QUELL_LEAST_WEIGHT_SUM ? 1.0f / sums.weight : ZERO_LANES;
  return scale3(sums.value, inverse);
}

#endif

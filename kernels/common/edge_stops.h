// Edge stops of the a-trous filter and of the spatial variance: a tap weighs e^-x, x the sum of the stops' penalties.
// Paper: Schied et al. 2017, eq. (3) to (5), after Flatval 2020, ch. 3.2 (depth scaled by its screen-space gradient).
// Departures: the gradient is the larger component times the distance in pixels, not the product of gradient and
//          offset: one division a pixel instead of one a tap (unbiased RMSE on four rendered sequences within 1 %);
//          its components are the smaller ones of the two one-sided differences, so that a silhouette is not taken for
//          a slope; the power of the cosine is e^(power * ln(cosine)) with two terms of the logarithm's series, which
//          makes a difference only to what weighs next to nothing; and see common/exponential.h for that e^-x.
#ifndef QUELL_COMMON_EDGE_STOPS_H
#define QUELL_COMMON_EDGE_STOPS_H

#include "common/edge_stops_params.h"
#include "common/exponential.h"
#include "common/guides.h"
#include "common/planes.h"

// The guides of the pixel in the middle of a filter.
typedef struct FilterCentre {
  float3L normal;
  floatL depth;
  floatL inverseDepth;  // pixels per scene unit of view depth that cost a penalty of 1
  floatL roughness;
  floatL inverseRoughness;  // 1 / difference that costs a penalty of 1
} FilterCentre;

QUELL_INLINE floatL smallerLanes(floatL a, floatL b) { return absLanes(a) < absLanes(b) ? a : b; }

// One-sided differences that leave the image stand back for the other one.
QUELL_INLINE floatL slopeAlong(__global const float* depth, int offset, floatL centre, intL hasBefore,
                               intL hasAfter) {
  const floatL before = centre - loadLanes(depth - offset);
  const floatL after = loadLanes(depth + offset) - centre;
  return hasBefore ? (hasAfter ? smallerLanes(before, after) : before) : (hasAfter ? after : ZERO_LANES);
}

QUELL_INLINE FilterCentre loadCentre(__global const float* guides, __global const float* viewDepth,
                                     __global const float* roughness, PlaneParams planes,
                                     EdgeStopParams stops, int x, int y) {
  const int index = planeIndex(planes, x, y);
  const intL column = x + LANE_INDEX;
  const intL row = (intL)(y);
  FilterCentre centre;
  centre.normal = loadLanes3(guides + QUELL_GUIDE_NORMAL * planes.stride, index, planes.stride);
  centre.depth = loadLanes(viewDepth + index);
  const floatL slopeX = slopeAlong(viewDepth + index, 1, centre.depth, column > 0, column < planes.width - 1);
  const floatL slopeY =
      slopeAlong(viewDepth + index, planes.pitch, centre.depth, row > 0, row < planes.height - 1);
  const floatL slope =
      maxLanes(absLanes(slopeX), absLanes(slopeY)) + QUELL_LEAST_SLOPE * absLanes(centre.depth);
  centre.inverseDepth = stops.inverseDepth / slope;
#if ROUGHNESS_STOP
  centre.roughness = loadLanes(roughness + index);
  centre.inverseRoughness =
      stops.inverseRoughness / maxLanes(centre.roughness, (floatL)(QUELL_LEAST_ROUGHNESS));
#else
  centre.roughness = ONE_LANES;
  centre.inverseRoughness = ZERO_LANES;
#endif
  return centre;
}

// Penalty of depth and normal of a tap at 1 / `inverseDistance` pixels; not below 0.
QUELL_INLINE floatL surfacePenalty(FilterCentre centre, EdgeStopParams stops, float3L normal, floatL depth,
                                   float inverseDistance) {
  // Of unit vectors: below 0 by no more than rounding.
  const floatL t =
      1.0f - centre.normal.x * normal.x - centre.normal.y * normal.y - centre.normal.z * normal.z;
  return (stops.normalPower + (0.5f * stops.normalPower) * t) * t +
         absLanes(depth - centre.depth) * (centre.inverseDepth * inverseDistance);
}

#if ROUGHNESS_STOP
QUELL_INLINE floatL roughnessPenalty(FilterCentre centre, floatL roughness) {
  return absLanes(roughness - centre.roughness) * centre.inverseRoughness;
}
#endif

#endif

// Fireflies: pixels that owe their light to one sample of rare brightness. Filters give them the less weight the brighter
// they are; the history keeps what they hold, since it may be the light of a small lamp, of which the rest comes later.
// Source: ours, after Mara et al. 2017, stage 6 of their filter: fireflies are taken from the picture outside of the loop of
//         the history, "otherwise the images would be too dark". Their 3x3 median would take small features, too.
#ifndef QUELL_COMMON_FIREFLIES_H
#define QUELL_COMMON_FIREFLIES_H

#include "common/fireflies_params.h"
#include "common/luminance.h"
#include "common/planes.h"

// Luminance of the brightest pixel of the ring around each pixel; -1 where none of it has a sample. A ring, since what
// moved was resampled, which spreads a firefly over its neighbours.
QUELL_INLINE floatL brightestAround(__global const float* irradiance, __global const float* weights,
                                    PlaneParams planes, int x, int y) {
  floatL brightest = (floatL)(-1.0f);
  for (int dy = -QUELL_FIREFLY_RING; dy <= QUELL_FIREFLY_RING; ++dy) {
    if (y + dy < 0 || y + dy >= planes.height) continue;
    for (int dx = -QUELL_FIREFLY_RING; dx <= QUELL_FIREFLY_RING; ++dx) {
      if (abs(dx) < QUELL_FIREFLY_RING && abs(dy) < QUELL_FIREFLY_RING) continue;
      const int index = planeIndex(planes, x + dx, y + dy);
      const intL column = x + dx + LANE_INDEX;
      const intL counts = column >= 0 && column < planes.width && loadLanes(weights + index) > 0.0f;
      const floatL tap = luminance(loadLanes3(irradiance, index, planes.stride));
      brightest = counts ? maxLanes(brightest, tap) : brightest;
    }
  }
  return brightest;
}

// What is left of the weights of `suspects` of this luminance.
QUELL_INLINE floatL fireflyShare(intL suspects, floatL luminance, floatL mostRatio,
                                 __global const float* irradiance, __global const float* weights,
                                 PlaneParams planes, int x, int y) {
  if (!anyLane(suspects)) return ONE_LANES;
  const floatL brightest = brightestAround(irradiance, weights, planes, x, y);
  const intL firefly = suspects && brightest >= 0.0f && luminance > mostRatio * brightest;
  const floatL ratio = brightest / luminance;
  return firefly ? maxLanes(ratio * ratio, (floatL)(QUELL_LEAST_FIREFLY_SHARE)) : ONE_LANES;
}

// What filters must find in background.
QUELL_INLINE void storeZeroWeights(__global float* tapWeights, int index, int stride) {
  for (int s = 0; s < QUELL_SIGNALS; ++s) storeLanes(ZERO_LANES, tapWeights + s * stride + index);
}

#endif

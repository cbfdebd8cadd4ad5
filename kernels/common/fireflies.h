// Fireflies: pixels that owe their light to one sample of rare brightness. Filters give them the less weight the brighter
// they are; the history keeps what they hold, since it may be the light of a small lamp, of which the rest comes later.
// Source: ours, after Mara et al. 2017, stage 6 of their filter: fireflies are taken from the picture outside of the loop of
//         the history, "otherwise the images would be too dark". Their 3x3 median would take small features, too.
#ifndef QUELL_COMMON_FIREFLIES_H
#define QUELL_COMMON_FIREFLIES_H

#include "common/fireflies_params.h"
#include "common/luminance.h"
#include "common/planes.h"

// The pixels around, as far as they lie in the image and have a sample.
typedef struct Ring {
  __global const float* irradiance;  // the planes of the signal
  __global const float* weights;
  PlaneParams planes;
  int x, y;
} Ring;

// The larger one of `brightest` and the luminance at this distance.
QUELL_INLINE floatL brighterOf(floatL brightest, Ring ring, int dx, int dy) {
  const int row = ring.y + dy;
  if (row < 0 || row >= ring.planes.height) return brightest;
  const int index = planeIndex(ring.planes, ring.x + dx, row);
  const intL column = ring.x + dx + LANE_INDEX;
  const intL counts = column >= 0 && column < ring.planes.width && loadLanes(ring.weights + index) > 0.0f;
  const floatL tap = luminance(loadLanes3(ring.irradiance, index, ring.planes.stride));
  return counts ? maxLanes(brightest, tap) : brightest;
}

// Luminance of the brightest pixel; -1 where there is none. A ring, since what moved was resampled, which spreads a
// firefly over its neighbours.
QUELL_INLINE floatL brightestOf(floatL brightest, Ring ring) {
  // Written out, all loads come first and take more registers than two waves have.
#pragma unroll 1
  for (int dy = -QUELL_FIREFLY_RING; dy <= QUELL_FIREFLY_RING; ++dy) {
#pragma unroll 1
    for (int dx = -QUELL_FIREFLY_RING; dx <= QUELL_FIREFLY_RING; ++dx) {
      if (abs(dx) < QUELL_FIREFLY_RING && abs(dy) < QUELL_FIREFLY_RING) continue;
      brightest = brighterOf(brightest, ring, dx, dy);
    }
  }
  return brightest;
}

// What is left of the weights of `suspects` of this luminance.
QUELL_INLINE floatL fireflyShare(intL suspects, floatL luminance, floatL mostRatio, Ring ring) {
  if (!anyLane(suspects)) return ONE_LANES;
  // Nearly always four of them tell that there is nothing to do.
  floatL brightest = (floatL)(-1.0f);
  for (int side = -QUELL_FIREFLY_RING; side <= QUELL_FIREFLY_RING; side += 2 * QUELL_FIREFLY_RING) {
    brightest = brighterOf(brightest, ring, side, 0);
    brightest = brighterOf(brightest, ring, 0, side);
  }
  if (!anyLane(suspects && luminance > mostRatio * brightest)) return ONE_LANES;
  brightest = brightestOf(brightest, ring);
  const intL firefly = suspects && brightest >= 0.0f && luminance > mostRatio * brightest;
  const floatL ratio = brightest / luminance;
  return firefly ? maxLanes(ratio * ratio, (floatL)(QUELL_LEAST_FIREFLY_SHARE)) : ONE_LANES;
}

// What filters must find in background.
QUELL_INLINE void storeZeroWeights(__global float* tapWeights, int index, int stride) {
  for (int s = 0; s < QUELL_SIGNALS; ++s) storeLanes(ZERO_LANES, tapWeights + s * stride + index);
}

#endif

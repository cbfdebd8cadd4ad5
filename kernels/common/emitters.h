// Emitters that are known by their colour alone: where there is no emission image, what has no factor (see
// common/demodulation.h) may be a lamp or a screen, which must neither be filtered nor spread, as well as a mirror, which
// must. What tells them apart is noise: light of one sample per pixel that is the same in neighbouring pixels has none.
#ifndef QUELL_COMMON_EMITTERS_H
#define QUELL_COMMON_EMITTERS_H

#include "common/demodulate_modes.h"
#include "common/material.h"
#include "common/planes.h"

#define FIND_EMITTERS                                \
  (DEMODULATE && !DEMODULATED && !EMISSION_FORMAT && \
   (ALBEDO_FORMAT || (QUELL_SIGNALS == 1 && GLOSSCOLOR_FORMAT)))

// Largest difference between pixels without noise, as a share of the brightest channel.
#define QUELL_NOISELESS_DIFFERENCE 0.01f
// Of the four nearest pixels as many must have the same light: a corner of a lamp has two. Two samples of noise as wide
// as the light itself are as near in one pair of a hundred.
#define QUELL_NOISELESS_NEIGHBOURS 2

#if FIND_EMITTERS
// 1 where the neighbour at (dx, dy) is in the image and as bright as `light` in every channel.
QUELL_INLINE floatL isAlike(FrameImages images, PlaneParams planes, float3L light, int x, int y, int dx,
                            int dy) {
  const intL column = x + dx + LANE_INDEX;
  const intL inside = insideColumns(planes, column);
  if (y + dy < 0 || y + dy >= planes.height) return ZERO_LANES;
  const float3L neighbour = GATHER_IMAGE(radiance, RADIANCE, inside ? column : (intL)(0), y + dy);
  const floatL most = QUELL_NOISELESS_DIFFERENCE * maxLanes(maxLanes(light.x, light.y), light.z);
  const float3L difference = subtract3(neighbour, light);
  const intL alike = inside && absLanes(difference.x) <= most && absLanes(difference.y) <= most &&
                     absLanes(difference.z) <= most;
  return alike ? ONE_LANES : ZERO_LANES;
}
#endif

// Whether pixels are emitters, as far as neighbours tell; never where a channel of the first signal is not weak.
QUELL_INLINE intL findEmitters(FrameImages images, PlaneParams planes, Signal signal, int x, int y) {
#if FIND_EMITTERS
  const intL candidate =
      signal.weak == QUELL_ALL_WEAK && anyChannel(signal.value) && x + LANE_INDEX < planes.width;
  if (!anyLane(candidate)) return (intL)(0);
  floatL count = ZERO_LANES;
  // The nearest four: left, above, below, right. Written out they are long to compile.
#pragma unroll 1
  for (int i = 0; i < 4; ++i)
    count += isAlike(images, planes, signal.value, x, y, i / 2 + i % 2 - 1, i / 2 - i % 2);
  return candidate && count >= (float)QUELL_NOISELESS_NEIGHBOURS;
#else
  return (intL)(0);
#endif
}

#endif

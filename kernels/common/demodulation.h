// Irradiance = (radiance - emission) / divisor, and back; the divisor is the material factor within bounds, so that light
// is kept whatever the factor.
//
// A channel whose factor is below QUELL_LEAST_FACTOR is weak: what light there is in it comes by other ways than the
// factor tells (a clear coat, or the mirror, glass and metal of renderers that write the diffuse colour alone). If not all
// channels are weak, it is divided by the largest factor, so that its light has the size of the others'. If all are,
// nothing is known to divide by, and light is filtered as it is. Which channels are weak makes kinds of pixels, whose lights have different units: with one signal, filters
// and history keep them apart (filteredNormal() in common/filter_input.h). Of two signals each has a factor of its own,
// which leaves nothing to a weak channel: it passes through, and counts for filters as grey.
#ifndef QUELL_COMMON_DEMODULATION_H
#define QUELL_COMMON_DEMODULATION_H

#include "common/image_access.h"

// Least and most that light is divided by (reflectance): the latter is albedo and gloss colour of 1 together.
#define QUELL_LEAST_FACTOR 0.01f
#define QUELL_MOST_FACTOR 2.0f

// Channels of a pixel, as bits.
#define QUELL_WEAK_X 1
#define QUELL_WEAK_Y 2
#define QUELL_WEAK_Z 4
#define QUELL_ALL_WEAK 7

// What is negative or not finite counts as 0.
QUELL_INLINE floatL cleanFactor(floatL factor) {
  return (isFinite(factor) && factor > 0.0f) ? minLanes(factor, (floatL)(QUELL_MAX_RADIANCE)) : ZERO_LANES;
}

QUELL_INLINE float3L cleanFactor3(float3L factor) {
  factor.x = cleanFactor(factor.x);
  factor.y = cleanFactor(factor.y);
  factor.z = cleanFactor(factor.z);
  return factor;
}

QUELL_INLINE intL bitIf(intL condition, int bit) { return condition ? (intL)(bit) : (intL)(0); }

// The weak channels of a factor that is clean.
QUELL_INLINE intL weakChannels(float3L factor) {
  return bitIf(factor.x < QUELL_LEAST_FACTOR, QUELL_WEAK_X) |
         bitIf(factor.y < QUELL_LEAST_FACTOR, QUELL_WEAK_Y) |
         bitIf(factor.z < QUELL_LEAST_FACTOR, QUELL_WEAK_Z);
}

// Divisor of each channel, positive.
QUELL_INLINE float3L divisorOf(float3L factor) {
  const floatL largest = maxLanes(maxLanes(factor.x, factor.y), factor.z);
  float3L divisor;
  divisor.x = factor.x < QUELL_LEAST_FACTOR ? largest : factor.x;
  divisor.y = factor.y < QUELL_LEAST_FACTOR ? largest : factor.y;
  divisor.z = factor.z < QUELL_LEAST_FACTOR ? largest : factor.z;
  return select3(largest < QUELL_LEAST_FACTOR, splat3(1.0f),
                 clamp3(divisor, QUELL_LEAST_FACTOR, QUELL_MOST_FACTOR));
}

// Radiance without emission, in [0, 65504]; 0 where either is not finite.
QUELL_INLINE float3L cleanSignal(float3L radiance, float3L emission, intL finite) {
  const float3L signal = clamp3(subtract3(radiance, emission), 0.0f, QUELL_MAX_RADIANCE);
  return select3(finite, signal, splat3(0.0f));
}

QUELL_INLINE float3L divideBy(float3L signal, float3L divisor) {
  signal.x /= divisor.x;
  signal.y /= divisor.y;
  signal.z /= divisor.z;
  return signal;
}

#endif

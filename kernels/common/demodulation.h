// Irradiance = (radiance - emission) / material factor, and back, continuous where the factor vanishes.
//
// Per channel: k = smoothstep(0, 0.01, factor); irradiance = signal / max(factor, 1e-6); the way back is
// k * factor * filtered + (1 - k) * signal. So black materials, emitters and sky pass through unfiltered and a
// material that fades to black fades to unfiltered, without a seam.
#ifndef QUELL_COMMON_DEMODULATION_H
#define QUELL_COMMON_DEMODULATION_H

#include "common/image_access.h"

// Factor from which on a channel is filtered entirely (reflectance, 0 to 1).
#define QUELL_DEMODULATION_FULL_FACTOR 0.01f
// Least divisor, so that a vanishing factor gives a large but finite irradiance (reflectance).
#define QUELL_DEMODULATION_LEAST_FACTOR 1e-6f

// Share of a channel that is filtered, 0 to 1. None below the least factor, where the share itself is below 3e-8: a
// weight must never be so small that its inverse overflows.
QUELL_INLINE floatL filteredShare(floatL factor) {
  const floatL t = clampLanes(factor * (1.0f / QUELL_DEMODULATION_FULL_FACTOR), 0.0f, 1.0f);
  return factor < QUELL_DEMODULATION_LEAST_FACTOR ? ZERO_LANES : t * t * (3.0f - 2.0f * t);
}

QUELL_INLINE float3L filteredShare3(float3L factor) {
  factor.x = filteredShare(factor.x);
  factor.y = filteredShare(factor.y);
  factor.z = filteredShare(factor.z);
  return factor;
}

// A factor that is negative or not finite counts as 0: such a pixel passes through.
QUELL_INLINE floatL cleanFactor(floatL factor) {
  return (isFinite(factor) && factor > 0.0f) ? minLanes(factor, (floatL)(QUELL_MAX_RADIANCE)) : ZERO_LANES;
}

QUELL_INLINE float3L cleanFactor3(float3L factor) {
  factor.x = cleanFactor(factor.x);
  factor.y = cleanFactor(factor.y);
  factor.z = cleanFactor(factor.z);
  return factor;
}

// Radiance without emission, in [0, 65504]; 0 where either is not finite.
QUELL_INLINE float3L cleanSignal(float3L radiance, float3L emission, intL finite) {
  const float3L signal = clamp3(subtract3(radiance, emission), 0.0f, QUELL_MAX_RADIANCE);
  return select3(finite, signal, splat3(0.0f));
}

QUELL_INLINE floatL divideByFactor(floatL signal, floatL factor) {
  return minLanes(signal / maxLanes(factor, (floatL)(QUELL_DEMODULATION_LEAST_FACTOR)),
                  (floatL)(QUELL_MAX_RADIANCE));
}

// Irradiance of a pixel and its weight as a filter tap. A channel whose factor vanishes tells nothing about the light;
// as all channels share one weight, it is filled with the mean of the channels that do, and the weight is the share
// of the best of them.
QUELL_INLINE float3L divideSignal(float3L signal, float3L factor, floatL* weight) {
  const float3L share = filteredShare3(factor);
  float3L irradiance;
  irradiance.x = divideByFactor(signal.x, factor.x);
  irradiance.y = divideByFactor(signal.y, factor.y);
  irradiance.z = divideByFactor(signal.z, factor.z);
  const floatL best = maxLanes(maxLanes(share.x, share.y), share.z);
  const floatL total = share.x + share.y + share.z;
  const floatL grey = dot3(irradiance, share) / (total > 0.0f ? total : ONE_LANES);
  const floatL inverseBest = 1.0f / (best > 0.0f ? best : ONE_LANES);
  irradiance.x = irradiance.x * (share.x * inverseBest) + grey * (1.0f - share.x * inverseBest);
  irradiance.y = irradiance.y * (share.y * inverseBest) + grey * (1.0f - share.y * inverseBest);
  irradiance.z = irradiance.z * (share.z * inverseBest) + grey * (1.0f - share.z * inverseBest);
  *weight = best;
  return irradiance;
}

#endif

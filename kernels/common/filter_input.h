// What filters need of the pixels at hand, from the caller's images: irradiance of each signal, whether it counts, and the
// normal that keeps kinds of pixels apart.
#ifndef QUELL_COMMON_FILTER_INPUT_H
#define QUELL_COMMON_FILTER_INPUT_H

#include "common/emitters.h"
#include "common/material.h"

typedef struct Sample {
  float3L irradiance;
  intL bare;     // passes through instead of being filtered; never present
  intL present;  // is there and counts
} Sample;

// Weak channels tell nothing about the light: the mean of the others stands in for them.
QUELL_INLINE float3L fillWeakChannels(float3L irradiance, intL weak) {
  const intL weakX = (weak & QUELL_WEAK_X) != 0, weakY = (weak & QUELL_WEAK_Y) != 0;
  const intL weakZ = (weak & QUELL_WEAK_Z) != 0;
  const floatL count =
      (weakX ? ZERO_LANES : ONE_LANES) + (weakY ? ZERO_LANES : ONE_LANES) + (weakZ ? ZERO_LANES : ONE_LANES);
  const floatL sum = (weakX ? ZERO_LANES : irradiance.x) + (weakY ? ZERO_LANES : irradiance.y) +
                     (weakZ ? ZERO_LANES : irradiance.z);
  const intL some = count > 0.0f;
  const floatL grey = sum / (some ? count : ONE_LANES);
  irradiance.x = weakX && some ? grey : irradiance.x;
  irradiance.y = weakY && some ? grey : irradiance.y;
  irradiance.z = weakZ && some ? grey : irradiance.z;
  return irradiance;
}

// `emits`: found to be an emitter; see findEmitters(). A signal that is faint is left out until one that is not has begun
// a history: most pixels lack one of two lobes, and their darkness must not be mixed into neighbours that have it.
QUELL_INLINE Sample makeSample(Signal signal, intL emits, intL hasHistory, intL validSurface) {
  Sample sample;
  sample.irradiance = divideBy(signal.value, signal.divisor);
#if QUELL_SIGNALS == 2
  sample.irradiance = fillWeakChannels(sample.irradiance, signal.weak);
#endif
  sample.bare = signal.finite && (signal.emits || emits || (signal.faint && !hasHistory));
  sample.present = signal.finite && validSurface && !sample.bare;
  return sample;
}

QUELL_INLINE float3L vector3(floatL x, floatL y, floatL z) {
  float3L v;
  v.x = x;
  v.y = y;
  v.z = z;
  return v;
}

// The normal that filters and history see. That of the only signal is turned by the channels that are weak, so that every
// test of normals takes pixels of two kinds for two surfaces: those without weak channels are at least 60 degrees away
// from all others, whatever the normal. Pairs of weak channels are told apart, single ones are not.
QUELL_INLINE float3L filteredNormal(float3L n, Signal first, intL validSurface) {
#if QUELL_SIGNALS == 1
  const intL weak = validSurface && !first.emits ? first.weak : (intL)(0);
  if (!anyLane(weak != 0)) return n;
  const float3L notX = vector3(n.y, -n.z, n.x), notY = vector3(n.z, n.x, -n.y);
  float3L turned = scale3(notY, (floatL)(-1.0f));
  turned = select3(weak == 0, n, turned);
  turned = select3(weak == QUELL_ALL_WEAK, scale3(n, (floatL)(-1.0f)), turned);
  turned = select3(weak == (QUELL_WEAK_Y | QUELL_WEAK_Z), notX, turned);
  turned = select3(weak == (QUELL_WEAK_X | QUELL_WEAK_Z), notY, turned);
  turned = select3(weak == (QUELL_WEAK_X | QUELL_WEAK_Y), scale3(notX, (floatL)(-1.0f)), turned);
  return turned;
#else
  return n;
#endif
}

#endif

// Light and material of a pixel: one signal (radiance as a whole, divided by albedo + gloss colour) or two (diffuse
// radiance, divided by albedo, and glossy radiance, divided by gloss colour), as far as the configuration has them.
//
// Compile options: QUELL_SIGNALS 1 or 2; DEMODULATED 1 where the caller has divided already; DEMODULATE 0 where light
// is to be filtered as it is.
#ifndef QUELL_COMMON_MATERIAL_H
#define QUELL_COMMON_MATERIAL_H

#include "common/demodulation.h"
#include "common/material_params.h"

typedef struct Signal {
  float3L value;   // without emission, [0, 65504]; 0 where it is broken
  float3L factor;  // filters see value / factor
  float3L tint;    // multiplied once more at the end
  intL finite;
} Signal;

typedef struct Material {
  Signal signals[QUELL_SIGNALS];
  float3L emission;  // 0 where there is none or it is broken
} Material;

// The images of one frame, in the order of every kernel's arguments.
#define MATERIAL_ARGUMENTS                                                      \
  __global const uchar *radianceData, __global const uchar *glossyRadianceData, \
      __global const uchar *emissionData, __global const uchar *albedoData,     \
      __global const uchar *glossColorData
#define LOAD_MATERIAL(params, x, y, lanes)                                                               \
  loadMaterial(radianceData, glossyRadianceData, emissionData, albedoData, glossColorData, params, x, y, \
               lanes)

// A signal that `color` tints: divided by it, unless the caller did so or nobody is to.
QUELL_INLINE Signal makeSignal(float3L radiance, float3L emission, intL emissionFinite, float3L color) {
  Signal signal;
  signal.finite = isFinite3(radiance) && emissionFinite;
  signal.value = cleanSignal(radiance, emission, signal.finite);
#if DEMODULATED
  signal.factor = splat3(1.0f);
  signal.tint = color;
#elif DEMODULATE
  signal.factor = color;
  signal.tint = splat3(1.0f);
#else
  signal.factor = splat3(1.0f);
  signal.tint = splat3(1.0f);
#endif
  return signal;
}

QUELL_INLINE Material loadMaterial(MATERIAL_ARGUMENTS, MaterialParams params, int x, int y, int lanes) {
  Material material;
#if ALBEDO_FORMAT
  const float3L albedo = cleanFactor3(LOAD_PIXELS(ALBEDO, albedoData, params.albedo, x, y, lanes));
#endif
#if GLOSSCOLOR_FORMAT
  const float3L glossColor =
      cleanFactor3(LOAD_PIXELS(GLOSSCOLOR, glossColorData, params.glossColor, x, y, lanes));
#endif
#if EMISSION_FORMAT
  const float3L emission = LOAD_PIXELS(EMISSION, emissionData, params.emission, x, y, lanes);
  const intL emissionFinite = isFinite3(emission);
  material.emission = select3(emissionFinite, emission, splat3(0.0f));
#else
  const intL emissionFinite = TRUE_LANES;
  material.emission = splat3(0.0f);
#endif
  const float3L radiance = LOAD_PIXELS(RADIANCE, radianceData, params.radiance, x, y, lanes);
#if DEMODULATED
  const float3L included = splat3(0.0f);  // irradiance has no emission in it
#else
  const float3L included = material.emission;
#endif

#if QUELL_SIGNALS == 2
#if !ALBEDO_FORMAT
  const float3L albedo = splat3(1.0f);
#endif
#if !GLOSSCOLOR_FORMAT
  const float3L glossColor = splat3(1.0f);
#endif
  material.signals[0] = makeSignal(radiance, included, emissionFinite, albedo);
  material.signals[1] =
      makeSignal(LOAD_PIXELS(GLOSSYRADIANCE, glossyRadianceData, params.glossyRadiance, x, y, lanes),
                 splat3(0.0f), TRUE_LANES, glossColor);
#elif ALBEDO_FORMAT && GLOSSCOLOR_FORMAT
  material.signals[0] = makeSignal(radiance, included, emissionFinite, add3(albedo, glossColor));
#elif ALBEDO_FORMAT
  material.signals[0] = makeSignal(radiance, included, emissionFinite, albedo);
#elif GLOSSCOLOR_FORMAT
  material.signals[0] = makeSignal(radiance, included, emissionFinite, glossColor);
#else
  material.signals[0] = makeSignal(radiance, included, emissionFinite, splat3(1.0f));
#endif
  return material;
}

#endif

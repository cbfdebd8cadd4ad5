// Light and material of a pixel: one signal (radiance as a whole, divided by albedo + gloss colour) or two (diffuse
// radiance, divided by albedo, and glossy radiance, divided by gloss colour), as far as the configuration has them.
//
// Compile options: QUELL_SIGNALS 1 or 2; DEMODULATED 1 where the caller has divided already; DEMODULATE, one of
// common/demodulate_modes.h; what the caller has divided lacks F_beta still.
#ifndef QUELL_COMMON_MATERIAL_H
#define QUELL_COMMON_MATERIAL_H

#include "common/demodulate_modes.h"
#include "common/demodulation.h"
#include "common/f_beta.h"
#include "common/material_params.h"
#include "common/planes.h"

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
#define LOAD_MATERIAL(params, fBeta, x, y, lanes)                                                            \
  loadMaterial(radianceData, glossyRadianceData, emissionData, albedoData, glossColorData, params, fBeta, x, \
               y, lanes)

// What F_beta is looked up with. Only the first kernel of a frame does so; fBetaPlanes (3) keep it for the last.
#define F_BETA_ARGUMENTS \
  __global const uchar *roughnessData, __global const uchar *f0Data, __global const float4 *fBetaTable

// Roughness in [0, 1] (GGX alpha is its square); 1, the roughness of a diffuse surface, where it is broken.
QUELL_INLINE floatL loadRoughness(__global const uchar* roughnessData, MaterialParams params, int x, int y,
                                  int lanes) {
#if ROUGHNESS_FORMAT
  const floatL roughness = LOAD_PIXELS(ROUGHNESS, roughnessData, params.roughness, x, y, lanes).x;
  return isFinite(roughness) ? clampLanes(roughness, 0.0f, 1.0f) : ONE_LANES;
#else
  return ONE_LANES;
#endif
}

// F_beta of the surface at this camera-relative position, 1 where light is not divided by it; F0 counts as 1 where it
// is absent.
QUELL_INLINE float3L loadFBeta(F_BETA_ARGUMENTS, MaterialParams params, float3L position, float3L normal,
                               int x, int y, int lanes) {
#if DEMODULATE == QUELL_DEMODULATE_F_BETA
#if F0_FORMAT
  const float3L f0 = clamp3(cleanFactor3(LOAD_PIXELS(F0, f0Data, params.f0, x, y, lanes)), 0.0f, 1.0f);
#else
  const float3L f0 = splat3(1.0f);
#endif
  float3L direction = position;
  if (params.viewAxis.w != 0.0f) {
    direction.x = (floatL)(params.viewAxis.x);
    direction.y = (floatL)(params.viewAxis.y);
    direction.z = (floatL)(params.viewAxis.z);
  }
  return surfaceFBeta3(fBetaTable, direction, normal, loadRoughness(roughnessData, params, x, y, lanes), f0);
#else
  return splat3(1.0f);
#endif
}

QUELL_INLINE void keepFBeta(float3L fBeta, __global float* fBetaPlanes, int index, int stride) {
#if DEMODULATE == QUELL_DEMODULATE_F_BETA
  storeLanes3(fBeta, fBetaPlanes, index, stride);
#endif
}

QUELL_INLINE float3L keptFBeta(__global const float* fBetaPlanes, int index, int stride) {
#if DEMODULATE == QUELL_DEMODULATE_F_BETA
  return loadLanes3(fBetaPlanes, index, stride);
#else
  return splat3(1.0f);
#endif
}

#if DEMODULATED
// a / b per channel; 1 where b vanishes.
QUELL_INLINE float3L divide3(float3L a, float3L b) {
  a.x = b.x > 0.0f ? a.x / b.x : ONE_LANES;
  a.y = b.y > 0.0f ? a.y / b.y : ONE_LANES;
  a.z = b.z > 0.0f ? a.z / b.z : ONE_LANES;
  return a;
}
#endif

// A signal that is tinted by `color`, which the caller may have divided by, and dimmed by `fBeta`.
QUELL_INLINE Signal makeSignal(float3L radiance, float3L emission, intL emissionFinite, float3L color,
                               float3L fBeta) {
  Signal signal;
  signal.finite = isFinite3(radiance) && emissionFinite;
  signal.value = cleanSignal(radiance, emission, signal.finite);
#if DEMODULATED
  signal.factor = fBeta;
  signal.tint = color;
#elif DEMODULATE
  signal.factor = multiply3(color, fBeta);
  signal.tint = splat3(1.0f);
#else
  signal.factor = splat3(1.0f);
  signal.tint = splat3(1.0f);
#endif
  return signal;
}

// `fBeta` counts where the configuration divides by it.
QUELL_INLINE Material loadMaterial(MATERIAL_ARGUMENTS, MaterialParams params, float3L fBeta, int x, int y,
                                   int lanes) {
  Material material;
  const float3L one = splat3(1.0f);
#if ALBEDO_FORMAT
  const float3L albedo = cleanFactor3(LOAD_PIXELS(ALBEDO, albedoData, params.albedo, x, y, lanes));
#else
  const float3L albedo = one;
#endif
#if EMISSION_FORMAT
  const float3L emission = LOAD_PIXELS(EMISSION, emissionData, params.emission, x, y, lanes);
  const intL emissionFinite = isFinite3(emission);
  material.emission = select3(emissionFinite, clamp3(emission, 0.0f, QUELL_MAX_RADIANCE), splat3(0.0f));
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
#if QUELL_SIGNALS == 2 || GLOSSCOLOR_FORMAT
#if GLOSSCOLOR_FORMAT
  const float3L glossColor =
      cleanFactor3(LOAD_PIXELS(GLOSSCOLOR, glossColorData, params.glossColor, x, y, lanes));
#else
  const float3L glossColor = one;
#endif
#endif

#if QUELL_SIGNALS == 2
  const float3L glossy = LOAD_PIXELS(GLOSSYRADIANCE, glossyRadianceData, params.glossyRadiance, x, y, lanes);
  material.signals[0] = makeSignal(radiance, included, emissionFinite, albedo, one);
  material.signals[1] = makeSignal(glossy, splat3(0.0f), TRUE_LANES, glossColor, fBeta);
#elif ALBEDO_FORMAT && GLOSSCOLOR_FORMAT
  // The caller has divided by albedo + gloss colour; what the glossy part is dimmed by is a share of that.
  const float3L dimmed = add3(albedo, multiply3(glossColor, fBeta));
#if DEMODULATED
  const float3L color = add3(albedo, glossColor);
  material.signals[0] = makeSignal(radiance, included, emissionFinite, color, divide3(dimmed, color));
#else
  material.signals[0] = makeSignal(radiance, included, emissionFinite, dimmed, one);
#endif
#elif GLOSSCOLOR_FORMAT
  material.signals[0] = makeSignal(radiance, included, emissionFinite, glossColor, fBeta);
#else
  material.signals[0] = makeSignal(radiance, included, emissionFinite, albedo, one);
#endif
  return material;
}

#endif

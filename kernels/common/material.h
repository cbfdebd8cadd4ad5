// Light and material of a pixel: one signal (radiance as a whole, divided by albedo + gloss colour) or two (diffuse
// radiance, divided by albedo, and glossy radiance, divided by gloss colour), as far as the configuration has them.
//
// Compile options: QUELL_SIGNALS 1 or 2; DEMODULATED 1 where the caller has divided already; DEMODULATE, one of
// common/demodulate_modes.h; what the caller has divided lacks F_beta still.
#ifndef QUELL_COMMON_MATERIAL_H
#define QUELL_COMMON_MATERIAL_H

#include "common/demodulate_modes.h"
#include "common/demodulation.h"
#include "common/frame_images.h"
#include "common/planes.h"

// Reflectance of dielectrics at normal incidence (index of refraction 1.5), and by how much albedo and gloss colour
// together must exceed 1 for gloss colour to be taken for one without Fresnel term; in between by degrees.
#define QUELL_DIELECTRIC_REFLECTANCE 0.04f
#define QUELL_SURE_EXCESS 0.1f

typedef struct Signal {
  float3L value;    // without emission, [0, 65504]; 0 where it is broken
  float3L divisor;  // filters see value / divisor; see common/demodulation.h
  float3L tint;     // multiplied once more at the end
  intL finite;
  intL weak;   // channels whose factor vanishes
  intL emits;  // an emitter: what is left without its emission is not filtered
  intL faint;  // of two signals, as if of a lobe that is not there
} Signal;

typedef struct Material {
  Signal signals[QUELL_SIGNALS];
  float3L emission;  // as far as radiance has it; 0 where there is none or it is broken
} Material;

// F_beta as the first stage of a frame has left it; 1 where light is not divided by it.
QUELL_INLINE float3L keptFBeta(__global const float* fBeta, int index, int stride) {
#if DEMODULATE == QUELL_DEMODULATE_F_BETA
  return loadLanes3(fBeta, index, stride);
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

QUELL_INLINE intL anyChannel(float3L v) { return v.x > 0.0f || v.y > 0.0f || v.z > 0.0f; }

// A signal that is tinted by `color`, which the caller may have divided by, and dimmed by `fBeta`.
QUELL_INLINE Signal makeSignal(float3L radiance, float3L emission, intL emissionFinite, float3L color,
                               float3L fBeta) {
  Signal signal;
  signal.finite = isFinite3(radiance) && emissionFinite;
  signal.value = cleanSignal(radiance, emission, signal.finite);
#if DEMODULATED
  const float3L factor = fBeta;
  signal.tint = color;
#elif DEMODULATE
  const float3L factor = multiply3(color, fBeta);
  signal.tint = splat3(1.0f);
#else
  const float3L factor = splat3(1.0f);
  signal.tint = splat3(1.0f);
#endif
  signal.weak = weakChannels(factor);
  signal.divisor = divisorOf(factor);
  const intL vanishes = signal.weak == QUELL_ALL_WEAK;
  signal.emits = vanishes && anyChannel(emission);
  signal.faint = QUELL_SIGNALS == 2 && vanishes && (!anyChannel(signal.value) || anyChannel(factor));
  return signal;
}

// Emission as radiance has it: a renderer that clamps radiance may not clamp emission, and what is added back must be no
// more than what was there. Emission of [0, 65504].
QUELL_INLINE float3L includedEmission(float3L emission, float3L radiance) {
#if DEMODULATED
  return emission;  // irradiance has none in it
#else
  float3L included;
  included.x = maxLanes(minLanes(emission.x, radiance.x), ZERO_LANES);
  included.y = maxLanes(minLanes(emission.y, radiance.y), ZERO_LANES);
  included.z = maxLanes(minLanes(emission.z, radiance.z), ZERO_LANES);
  return select3(isFinite3(radiance), included, emission);
#endif
}

#if QUELL_SIGNALS == 1 && ALBEDO_FORMAT && GLOSSCOLOR_FORMAT && !DEMODULATED
// Reflectance at normal incidence where F0_DIMS_GLOSS says that it counts; without the image that of dielectrics.
QUELL_INLINE float3L loadF0(FrameImages images, int x, int y, int lanes) {
#if F0_FORMAT && DEMODULATE == QUELL_DEMODULATE_ALBEDO
  return clamp3(cleanFactor3(LOAD_IMAGE(f0, F0, x, y, lanes)), 0.0f, 1.0f);
#else
  return splat3(QUELL_DIELECTRIC_REFLECTANCE);
#endif
}

// Gloss colour as a reflectance. No surface reflects more than all light: where albedo and gloss colour say so, the latter
// lacks the Fresnel term (Blender before 4.0 has 1 for plastics, and so has quell render), and that much of it counts.
QUELL_INLINE float3L plausibleGloss(float3L albedo, float3L gloss, float3L f0) {
  const float3L over = add3(subtract3(albedo, splat3(1.0f)), gloss);  // so that little is lost to rounding
  const floatL excess = maxLanes(maxLanes(over.x, over.y), over.z);
  const floatL share = clampLanes(excess * (1.0f / QUELL_SURE_EXCESS), 0.0f, 1.0f);
  return subtract3(gloss, scale3(multiply3(gloss, subtract3(splat3(1.0f), f0)), share));
}
#endif

// `fBeta` counts where the configuration divides by it.
QUELL_INLINE Material loadMaterial(FrameImages images, float3L fBeta, int x, int y, int lanes) {
  Material material;
  const float3L one = splat3(1.0f);
#if ALBEDO_FORMAT
  const float3L albedo = cleanFactor3(LOAD_IMAGE(albedo, ALBEDO, x, y, lanes));
#else
  const float3L albedo = one;
#endif
  const float3L radiance = LOAD_IMAGE(radiance, RADIANCE, x, y, lanes);
#if EMISSION_FORMAT
  const float3L emission = LOAD_IMAGE(emission, EMISSION, x, y, lanes);
  const intL emissionFinite = isFinite3(emission);
  material.emission = includedEmission(
      select3(emissionFinite, clamp3(emission, 0.0f, QUELL_MAX_RADIANCE), splat3(0.0f)), radiance);
#else
  const intL emissionFinite = TRUE_LANES;
  material.emission = splat3(0.0f);
#endif
#if DEMODULATED
  const float3L included = splat3(0.0f);  // irradiance has no emission in it
#else
  const float3L included = material.emission;
#endif
#if QUELL_SIGNALS == 2 || GLOSSCOLOR_FORMAT
#if GLOSSCOLOR_FORMAT
  const float3L glossColor = cleanFactor3(LOAD_IMAGE(glossColor, GLOSSCOLOR, x, y, lanes));
#else
  const float3L glossColor = one;
#endif
#endif

#if QUELL_SIGNALS == 2
  const float3L glossy = LOAD_IMAGE(glossyRadiance, GLOSSYRADIANCE, x, y, lanes);
  material.signals[0] = makeSignal(radiance, included, emissionFinite, albedo, one);
  material.signals[1] = makeSignal(glossy, splat3(0.0f), TRUE_LANES, glossColor, fBeta);
#elif ALBEDO_FORMAT && GLOSSCOLOR_FORMAT
  const float3L gloss = multiply3(glossColor, fBeta);
#if DEMODULATED
  // The caller has divided by albedo + gloss colour; what the glossy part is dimmed by is a share of that.
  const float3L dimmed = add3(albedo, gloss);
  const float3L color = add3(albedo, glossColor);
  material.signals[0] = makeSignal(radiance, included, emissionFinite, color, divide3(dimmed, color));
#else
  const float3L color = add3(albedo, plausibleGloss(albedo, gloss, loadF0(images, x, y, lanes)));
  material.signals[0] = makeSignal(radiance, included, emissionFinite, color, one);
#endif
#elif GLOSSCOLOR_FORMAT
  material.signals[0] = makeSignal(radiance, included, emissionFinite, glossColor, fBeta);
#else
  material.signals[0] = makeSignal(radiance, included, emissionFinite, albedo, one);
#endif
  return material;
}

#endif

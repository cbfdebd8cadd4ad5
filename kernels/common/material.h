// What a pixel's light is divided by before filters see it: loads emission, albedo and gloss colour, as far as the
// configuration has them.
#ifndef QUELL_COMMON_MATERIAL_H
#define QUELL_COMMON_MATERIAL_H

#include "common/demodulation.h"

typedef struct Material {
  float3L radiance;  // as the caller gave it
  float3L emission;  // 0 where there is none
  float3L factor;    // albedo + gloss colour, cleaned; 1 where there is neither
  intL emissionFinite;
  intL finite;  // neither radiance nor emission is broken
} Material;

// The images and views of one frame, in the order of every kernel's arguments.
#define LOAD_MATERIAL(radianceData, emissionData, albedoData, glossColorData, params, x, y, lanes)           \
  loadMaterial(radianceData, emissionData, albedoData, glossColorData, (params).radiance, (params).emission, \
               (params).albedo, (params).glossColor, x, y, lanes)

QUELL_INLINE Material loadMaterial(__global const uchar* radianceData, __global const uchar* emissionData,
                                   __global const uchar* albedoData, __global const uchar* glossColorData,
                                   ImageViewParams radiance, ImageViewParams emission, ImageViewParams albedo,
                                   ImageViewParams glossColor, int x, int y, int lanes) {
  Material material;
  material.radiance = LOAD_PIXELS(RADIANCE, radianceData, radiance, x, y, lanes);
#if EMISSION_FORMAT
  material.emission = LOAD_PIXELS(EMISSION, emissionData, emission, x, y, lanes);
#else
  material.emission = splat3(0.0f);
#endif
#if ALBEDO_FORMAT && GLOSSCOLOR_FORMAT
  material.factor = add3(cleanFactor3(LOAD_PIXELS(ALBEDO, albedoData, albedo, x, y, lanes)),
                         cleanFactor3(LOAD_PIXELS(GLOSSCOLOR, glossColorData, glossColor, x, y, lanes)));
#elif ALBEDO_FORMAT
  material.factor = cleanFactor3(LOAD_PIXELS(ALBEDO, albedoData, albedo, x, y, lanes));
#elif GLOSSCOLOR_FORMAT
  material.factor = cleanFactor3(LOAD_PIXELS(GLOSSCOLOR, glossColorData, glossColor, x, y, lanes));
#else
  material.factor = splat3(1.0f);
#endif
  material.emissionFinite = isFinite3(material.emission);
  material.finite = isFinite3(material.radiance) && material.emissionFinite;
  return material;
}

#endif

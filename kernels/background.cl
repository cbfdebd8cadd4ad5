// background: where a work-item's pixels show nothing but background, everything from radiance to display in one pass,
//          so that remodulate and temporal_antialiasing can leave them out.
// Source:  ours; radiance and encoding are those of remodulate. Without sub-pixel jitter the background is
//          met in the same way in every frame and needs no antialiasing over time.
// In:      the caller's radiance (or diffuse and glossy radiance) and emission, surfaces (see common/surfaces.h).
// Out:     linear radiance in the caller's layout, display-encoded radiance as 3 planes (next to surfaces, which
//          bound their history with it), as history of temporal_antialiasing (3 planes) and in the caller's layout.
#include "background_params.h"
#include "common/display_encoding.h"
#include "common/material.h"
#include "common/surfaces.h"

// With nothing to take out and add back, radiance is the result.
#define RADIANCE_IS_ALL (!DEMODULATED && QUELL_SIGNALS == 1 && !EMISSION_FORMAT)

// Radiance of the background, as remodulate has it.
QUELL_INLINE float3L backgroundRadiance(MATERIAL_ARGUMENTS, MaterialParams params, int x, int y, int lanes) {
#if RADIANCE_IS_ALL
  const float3L radiance = LOAD_PIXELS(RADIANCE, radianceData, params.radiance, x, y, lanes);
  const intL whole = isFinite3(radiance);
  if (!anyLane(!whole)) return radiance;
#endif
  const Material material = LOAD_MATERIAL(params, splat3(1.0f), x, y, lanes);
  float3L sum = material.emission;
  for (int s = 0; s < QUELL_SIGNALS; ++s)
    sum = add3(sum, multiply3(material.signals[s].tint, material.signals[s].value));
#if RADIANCE_IS_ALL
  sum = select3(whole, radiance, sum);
#endif
  return sum;
}

__kernel void background(MATERIAL_ARGUMENTS, __global const uchar* surfaces, __global float* encodedPlanes,
                         __global float* antialiased, __global uchar* linearData, __global uchar* displayData,
                         BackgroundParams params) {
  const PlaneParams planes = params.planes;
  const int x = (int)get_global_id(0) * QUELL_LANES;
  const int y = (int)get_global_id(1);
  if (x >= planes.width || y >= planes.height) return;
  if (!isBackground(surfaces, planes, x, y)) return;
  const int lanes = min(QUELL_LANES, planes.width - x);
  const float3L radiance =
      clamp3(backgroundRadiance(radianceData, glossyRadianceData, emissionData, albedoData, glossColorData,
                                params.material, x, y, lanes),
             0.0f, QUELL_MAX_RADIANCE);
#if LINEAROUTPUT_FORMAT
  STORE_PIXELS(LINEAROUTPUT, radiance, linearData, params.linearOutput, x, y, lanes);
#endif
#if DISPLAYOUTPUT_FORMAT
  const float3L encoded = encodeDisplay3(radiance);
#if ANTIALIAS
  const int index = planeIndex(planes, x, y);
  if (params.finish == 0 || isNearSurface(surfaces, planes, x, y))
    storeLanes3(encoded, encodedPlanes, index, planes.stride);
  if (params.finish == 0) return;
  storeLanes3(encoded, antialiased, index, planes.stride);
#endif
  STORE_PIXELS(DISPLAYOUTPUT, encoded, displayData, params.displayOutput, x, y, lanes);
#endif
}

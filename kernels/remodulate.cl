// remodulate: filtered irradiance back to radiance, per signal k * factor * filtered + (1 - k) * signal, plus emission;
//             and its display encoding.
// Paper:   Koskela et al. 2019, post-processing: albedo, removed before phase I, is multiplied back. The blend k is
//          described in common/demodulation.h. Display encoding: reference implementation (the paper leaves the tone
//          map to the renderer).
// In:      filtered irradiance (3 planes per signal), guides, the caller's radiance (or diffuse and glossy radiance),
//          emission, albedo and gloss colour; F_beta (3 planes) where light was divided by it.
// Out:     linear radiance in the caller's layout, finite, in [0, 65504]; display-encoded radiance in [0, 1] as 3 planes
//          (for temporal_antialiasing) or in the caller's layout (without it); of each what the caller wants.
//          Background and broken surfaces pass the signal through; a missing sample there is black.
#include "common/display_encoding.h"
#include "common/guides.h"
#include "common/material.h"
#include "common/planes.h"
#include "common/surfaces.h"
#include "remodulate_params.h"

QUELL_INLINE floatL blendChannel(floatL share, floatL factor, floatL filtered, floatL signal) {
  return share * (factor * filtered) + (1.0f - share) * signal;
}

// Radiance of one signal; its filtered value counts only on surfaces.
QUELL_INLINE float3L remodulateSignal(Signal signal, float3L filtered, intL surface) {
  const float3L share = select3(surface, filteredShare3(signal.factor), splat3(0.0f));
  float3L radiance;
  radiance.x = blendChannel(share.x, signal.factor.x, filtered.x, signal.value.x);
  radiance.y = blendChannel(share.y, signal.factor.y, filtered.y, signal.value.y);
  radiance.z = blendChannel(share.z, signal.factor.z, filtered.z, signal.value.z);
  return multiply3(signal.tint, radiance);
}

__kernel void remodulate(__global const float* filtered, __global const float* guides,
                         __global const float* fBetaPlanes, MATERIAL_ARGUMENTS, __global float* encodedPlanes,
                         __global uchar* linearData, __global uchar* displayData,
                         __global const uchar* surfaces, RemodulateParams params) {
  const PlaneParams planes = params.planes;
  const int x = (int)get_global_id(0) * QUELL_LANES;
  const int y = (int)get_global_id(1);
  if (x >= planes.width || y >= planes.height) return;
#if SKIP
  if (isBackground(surfaces, planes, x, y)) return;  // the stage background has done it
#endif
  const int lanes = min(QUELL_LANES, planes.width - x);
  const int index = planeIndex(planes, x, y);

  const float3L normal = loadLanes3(guides + QUELL_GUIDE_NORMAL * planes.stride, index, planes.stride);
  const float3L fBeta = keptFBeta(fBetaPlanes, index, planes.stride);
  const Material material = LOAD_MATERIAL(params.material, fBeta, x, y, lanes);
  const intL surface = dot3(normal, normal) > 0.0f;
  float3L radianceOut = material.emission;
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const float3L value = loadLanes3(filtered + 3 * s * planes.stride, index, planes.stride);
    radianceOut = add3(radianceOut, remodulateSignal(material.signals[s], value, surface));
  }
  radianceOut = clamp3(radianceOut, 0.0f, QUELL_MAX_RADIANCE);
#if LINEAROUTPUT_FORMAT
  STORE_PIXELS(LINEAROUTPUT, radianceOut, linearData, params.linearOutput, x, y, lanes);
#endif
#if WRITE_PLANES
  storeLanes3(encodeDisplay3(radianceOut), encodedPlanes, index, planes.stride);
#elif DISPLAYOUTPUT_FORMAT
  STORE_PIXELS(DISPLAYOUTPUT, encodeDisplay3(radianceOut), displayData, params.displayOutput, x, y, lanes);
#endif
}

// remodulate: filtered irradiance back to radiance: k * factor * filtered + (1 - k) * signal, plus emission.
// Paper:   Koskela et al. 2019, post-processing: albedo, removed before phase I, is multiplied back. The blend k is
//          described in common/demodulation.h.
// In:      filtered irradiance (3 planes), guides, the caller's radiance, emission, albedo and gloss colour.
// Out:     linear radiance as 3 planes and, if the caller wants it, in the caller's layout; finite, in [0, 65504].
//          Background and broken surfaces pass the signal through; a missing sample there is black.
#include "accumulate_noisy_params.h"
#include "common/material.h"
#include "common/planes.h"
#include "remodulate_params.h"

__kernel void remodulate(__global const float* filtered, __global const float* guides,
                         __global const uchar* radianceData, __global const uchar* emissionData,
                         __global const uchar* albedoData, __global const uchar* glossColorData,
                         __global float* linearPlanes, __global uchar* outputData, RemodulateParams params) {
  const PlaneParams planes = params.planes;
  const int x = (int)get_global_id(0) * QUELL_LANES;
  const int y = (int)get_global_id(1);
  if (x >= planes.width || y >= planes.height) return;
  const int lanes = min(QUELL_LANES, planes.width - x);
  const int index = planeIndex(planes, x, y);

  const Material material =
      LOAD_MATERIAL(radianceData, emissionData, albedoData, glossColorData, params, x, y, lanes);
#if DEMODULATED
  const float3L signal =
      multiply3(cleanSignal(material.radiance, splat3(0.0f), material.finite), material.factor);
  float3L share = splat3(1.0f);
#else
  const float3L signal = cleanSignal(material.radiance, material.emission, material.finite);
  float3L share = filteredShare3(material.factor);
#endif
  const float3L normal = loadLanes3(guides + QUELL_GUIDE_NORMAL * planes.stride, index, planes.stride);
  const intL surface = dot3(normal, normal) > 0.0f;
  share = select3(surface, share, splat3(0.0f));

  float3L radianceOut = multiply3(material.factor, loadLanes3(filtered, index, planes.stride));
  radianceOut.x = share.x * radianceOut.x + (1.0f - share.x) * signal.x;
  radianceOut.y = share.y * radianceOut.y + (1.0f - share.y) * signal.y;
  radianceOut.z = share.z * radianceOut.z + (1.0f - share.z) * signal.z;
  radianceOut = add3(radianceOut, select3(material.emissionFinite, material.emission, splat3(0.0f)));
  radianceOut = clamp3(radianceOut, 0.0f, QUELL_MAX_RADIANCE);
#if WRITE_PLANES
  storeLanes3(radianceOut, linearPlanes, index, planes.stride);
#endif
#if OUTPUT_FORMAT
  STORE_PIXELS(OUTPUT, radianceOut, outputData, params.output, x, y, lanes);
#endif
}

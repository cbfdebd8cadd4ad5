// material_guides: albedo and roughness of this frame as planes, for fits with features made of them.
// Paper:   Koskela et al. 2019, section on the choice of feature buffers (material roughness).
// In:      the caller's albedo and roughness, any layout; an image that no feature needs is compiled out.
// Out:     materials: planes of albedo (3) and roughness (1), 0 to 1. What is not finite counts as 0.
#include "common/image_access.h"
#include "common/planes.h"
#include "fit_params.h"
#include "material_guides_params.h"

QUELL_INLINE floatL cleanGuide(floatL v) { return isFinite(v) ? clampLanes(v, 0.0f, 1.0f) : ZERO_LANES; }

__kernel void material_guides(__global const uchar* albedoData, __global const uchar* roughnessData,
                              __global float* materials, MaterialGuidesParams params) {
  const PlaneParams planes = params.planes;
  const int x = (int)get_global_id(0) * QUELL_LANES;
  const int y = (int)get_global_id(1);
  if (x >= planes.width || y >= planes.height) return;
  const int lanes = min(QUELL_LANES, planes.width - x);
  const int index = planeIndex(planes, x, y);
#if ALBEDO_FORMAT
  float3L albedo = LOAD_PIXELS(ALBEDO, albedoData, params.albedo, x, y, lanes);
  albedo.x = cleanGuide(albedo.x);
  albedo.y = cleanGuide(albedo.y);
  albedo.z = cleanGuide(albedo.z);
  storeLanes3(albedo, materials + QUELL_MATERIAL_ALBEDO * planes.stride, index, planes.stride);
#endif
#if ROUGHNESS_FORMAT
  const floatL roughness = LOAD_PIXELS(ROUGHNESS, roughnessData, params.roughness, x, y, lanes).x;
  storeLanes(cleanGuide(roughness), materials + QUELL_MATERIAL_ROUGHNESS * planes.stride + index);
#endif
}

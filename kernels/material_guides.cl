// material_guides: albedo and roughness of this frame as planes, for fits with features made of them.
// Paper:   Koskela et al. 2019, section on the choice of feature buffers (material roughness).
// In:      the caller's albedo and roughness, any layout; an image that no feature needs is compiled out.
// Out:     materials: planes of albedo (3) and roughness (1), 0 to 1. What is not finite counts as 0.
#include "common/frame_images.h"
#include "common/surfaces.h"
#include "material_guides_ports.h"

QUELL_INLINE floatL cleanGuide(floatL v) { return isFinite(v) ? clampLanes(v, 0.0f, 1.0f) : ZERO_LANES; }

__kernel void material_guides(STAGE_ARGUMENTS(MATERIAL_GUIDES) MaterialGuidesParams params) {
  BEGIN_PIXELS(params.planes);
  BIND_FRAME_IMAGES(MATERIAL_GUIDES, params.images);
  const int lanes = min(QUELL_LANES, planes.width - x);
#if ALBEDO_FORMAT
  float3L albedo = LOAD_IMAGE(albedo, ALBEDO, x, y, lanes);
  albedo.x = cleanGuide(albedo.x);
  albedo.y = cleanGuide(albedo.y);
  albedo.z = cleanGuide(albedo.z);
  storeLanes3(albedo, materials + QUELL_MATERIAL_ALBEDO * stride, index, stride);
#endif
#if ROUGHNESS_FORMAT
  const floatL roughness = LOAD_IMAGE(roughness, ROUGHNESS, x, y, lanes).x;
  storeLanes(cleanGuide(roughness), materials + QUELL_MATERIAL_ROUGHNESS * stride + index);
#endif
}

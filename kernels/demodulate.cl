// demodulate: the caller's images of one frame to what filters read, without any history.
// Paper:   Koskela et al. 2019, section 3 (albedo is removed before filtering); Zhuang et al. 2021 for the glossy signal.
// In:      the caller's radiance (or diffuse and glossy radiance), normal, position (or view depth), optional emission,
//          albedo, gloss colour and roughness, any layout.
// Out:     irradiance (3 planes per signal), guides (see common/guides.h), view depth (1 plane) and, where the caller
//          has it, roughness (1 plane), F_beta (3 planes) where light is divided by it. A missing sample is 0 and has the weight 0.
#include "common/filter_input.h"
#include "common/surface_images.h"
#include "demodulate_params.h"

__kernel void demodulate(MATERIAL_ARGUMENTS, F_BETA_ARGUMENTS, SURFACE_ARGUMENTS, __global float* irradiance,
                         __global float* guides, __global float* viewDepth, __global float* roughness,
                         __global float* fBetaPlanes, DemodulateParams params) {
  const PlaneParams planes = params.planes;
  const int stride = planes.stride;
  const int x = (int)get_global_id(0) * QUELL_LANES;
  const int y = (int)get_global_id(1);
  if (x >= planes.width || y >= planes.height) return;
  const int lanes = min(QUELL_LANES, planes.width - x);
  const int index = planeIndex(planes, x, y);

  const Surface surface =
      loadSurface(normalData, positionData, params.surface, params.reprojection, x, y, lanes);
  const float3L fBeta = loadFBeta(roughnessData, f0Data, fBetaTable, params.material, surface.position,
                                  surface.normal, x, y, lanes);
  keepFBeta(fBeta, fBetaPlanes, index, stride);
  const Material material = LOAD_MATERIAL(params.material, fBeta, x, y, lanes);
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const Sample sample = makeSample(material.signals[s], surface.valid);
    storeLanes3(select3(sample.present, sample.irradiance, splat3(0.0f)), irradiance + 3 * s * stride, index,
                stride);
    storeLanes(sample.present ? sample.weight : ZERO_LANES,
               guides + (QUELL_GUIDE_WEIGHT + s) * stride + index);
  }
  storeLanes3(surface.position, guides + QUELL_GUIDE_POSITION * stride, index, stride);
  storeLanes3(surface.normal, guides + QUELL_GUIDE_NORMAL * stride, index, stride);
  storeLanes(affine(params.reprojection.viewDepth, surface.position), viewDepth + index);
#if ROUGHNESS_FORMAT
  storeLanes(loadRoughness(roughnessData, params.material, x, y, lanes), roughness + index);
#endif
}

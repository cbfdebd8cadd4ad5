// demodulate: the caller's images of one frame to what filters read, without any history.
// Paper:   Koskela et al. 2019, section 3 (albedo is removed before filtering); Zhuang et al. 2021 for the glossy signal.
// In:      the caller's radiance (or diffuse and glossy radiance), normal, position (or view depth), optional emission,
//          albedo, gloss colour, roughness and F0, any layout; the table of F_beta where light is divided by it.
// Out:     irradiance (3 planes per signal), guides (see common/guides.h), view depth (1 plane) and, where the caller
//          has it, roughness (1 plane); F_beta (3 planes) where light is divided by it; with SKIP `surfaces` (see
//          common/surfaces.h). A missing sample is 0 and has the weight 0.
#include "common/f_beta_images.h"
#include "common/filter_input.h"
#include "common/surface_images.h"
#include "demodulate_ports.h"

__kernel void demodulate(STAGE_ARGUMENTS(DEMODULATE) DemodulateParams params) {
  BEGIN_PIXELS(params.planes);
  BIND_FRAME_IMAGES(DEMODULATE, params.images);
  const int lanes = min(QUELL_LANES, planes.width - x);
#if SKIP
  if (!markSurface(images, surfaces, planes, x, y, lanes)) {
    storeBackgroundWeights(guides, index, stride);
    storeLanes((floatL)(params.reprojection.viewDepth.w), viewDepth + index);
    return;
  }
#endif
  Surface surface = loadSurface(images, params.reprojection, x, y, lanes);
  const float3L fBetaHere =
      loadFBeta(images, fBetaTable, params.reprojection, surface.position, surface.normal, x, y, lanes);
  keepFBeta(fBetaHere, fBeta, index, stride);
  const Material material = loadMaterial(images, fBetaHere, x, y, lanes);
  surface.normal = filteredNormal(surface.normal, material.signals[0], surface.valid);
  const intL emits = findEmitters(images, planes, material.signals[0], x, y);
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const Sample sample =
        makeSample(material.signals[s], s == 0 ? emits : (intL)(0), (intL)(0), surface.valid);
    storeLanes3(select3(sample.present, sample.irradiance, splat3(0.0f)), irradiance + 3 * s * stride, index,
                stride);
    storeLanes(sample.present ? ONE_LANES : ZERO_LANES, guides + (QUELL_GUIDE_WEIGHT + s) * stride + index);
  }
  storeLanes3(surface.position, guides + QUELL_GUIDE_POSITION * stride, index, stride);
  storeLanes3(surface.normal, guides + QUELL_GUIDE_NORMAL * stride, index, stride);
  storeLanes(affine(params.reprojection.viewDepth, surface.position), viewDepth + index);
#if ROUGHNESS_FORMAT
  storeLanes(loadRoughness(images, x, y, lanes), roughness + index);
#endif
}

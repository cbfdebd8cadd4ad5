// F_beta of the pixels at hand, looked up with the caller's images of roughness and F0. Only the first stage of a frame
// does so; planes keep it for the last.
#ifndef QUELL_COMMON_F_BETA_IMAGES_H
#define QUELL_COMMON_F_BETA_IMAGES_H

#include "common/demodulation.h"
#include "common/f_beta.h"
#include "common/f_beta_ports.h"
#include "common/frame_images.h"
#include "common/planes.h"
#include "common/reprojection_params.h"

// Roughness in [0, 1] (GGX alpha is its square); 1, the roughness of a diffuse surface, where it is broken.
QUELL_INLINE floatL loadRoughness(FrameImages images, int x, int y, int lanes) {
#if ROUGHNESS_FORMAT
  const floatL roughness = LOAD_IMAGE(roughness, ROUGHNESS, x, y, lanes).x;
  return isFinite(roughness) ? clampLanes(roughness, 0.0f, 1.0f) : ONE_LANES;
#else
  return ONE_LANES;
#endif
}

// F_beta of the surface at this camera-relative position, 1 where light is not divided by it; F0 counts as 1 where it
// is absent.
QUELL_INLINE float3L loadFBeta(FrameImages images, __global const float4* table,
                               ReprojectionParams reprojection, float3L position, float3L normal, int x,
                               int y, int lanes) {
#if DEMODULATE == QUELL_DEMODULATE_F_BETA
#if F0_FORMAT
  const float3L f0 = clamp3(cleanFactor3(LOAD_IMAGE(f0, F0, x, y, lanes)), 0.0f, 1.0f);
#else
  const float3L f0 = splat3(1.0f);
#endif
  float3L direction = position;
  const int orthographic =
      reprojection.clipW.x == 0.0f && reprojection.clipW.y == 0.0f && reprojection.clipW.z == 0.0f;
  if (orthographic) {
    direction.x = (floatL)(reprojection.viewDepth.x);
    direction.y = (floatL)(reprojection.viewDepth.y);
    direction.z = (floatL)(reprojection.viewDepth.z);
  }
  return surfaceFBeta3(table, direction, normal, loadRoughness(images, x, y, lanes), f0);
#else
  return splat3(1.0f);
#endif
}

QUELL_INLINE void keepFBeta(float3L value, __global float* fBeta, int index, int stride) {
#if DEMODULATE == QUELL_DEMODULATE_F_BETA
  storeLanes3(value, fBeta, index, stride);
#endif
}

#endif

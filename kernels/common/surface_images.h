// The caller's images of a surface: normal, world position or view depth.
#ifndef QUELL_COMMON_SURFACE_IMAGES_H
#define QUELL_COMMON_SURFACE_IMAGES_H

#include "common/frame_images.h"
#include "common/guides.h"
#include "common/reprojection.h"
#include "common/surfaces.h"

// Pixels whose normal is that of a surface, whatever their position.
QUELL_INLINE intL hasNormal(FrameImages images, int x, int y, int lanes) {
  const float3L normal = LOAD_IMAGE(normalWorld, NORMALWORLD, x, y, lanes);
  return isSurfaceNormal(dot3(normal, normal)) && LANE_INDEX < lanes;
}

#if SKIP
// Whether there is a surface in these pixels, which `surfaces` then says as well; see common/surfaces.h.
QUELL_INLINE int markSurface(FrameImages images, __global uchar* surfaces, PlaneParams planes, int x, int y,
                             int lanes) {
  const int hasSurface = anyLane(hasNormal(images, x, y, lanes));
  surfaces[surfaceIndex(planes, x, y)] = (uchar)(hasSurface ? 1 : 0);
  return hasSurface;
}

// Background weighs nothing as a filter tap.
QUELL_INLINE void storeBackgroundWeights(__global float* guides, int index, int stride) {
  for (int s = 0; s < QUELL_SIGNALS; ++s)
    storeLanes(ZERO_LANES, guides + (QUELL_GUIDE_WEIGHT + s) * stride + index);
}
#endif

// Lanes from `lanes` on are not valid.
QUELL_INLINE Surface loadSurface(FrameImages images, ReprojectionParams reprojection, int x, int y,
                                 int lanes) {
  const float3L normal = LOAD_IMAGE(normalWorld, NORMALWORLD, x, y, lanes);
#if VIEWDEPTH_FORMAT
  const float3L ray = viewRay(reprojection, TO_FLOAT(x + LANE_INDEX), (floatL)((float)y));
  Surface surface;
  surface.position = scale3(ray, LOAD_IMAGE(viewDepth, VIEWDEPTH, x, y, lanes).x);
  surface.normal = normal;
#else
  const float3L position = LOAD_IMAGE(positionWorld, POSITIONWORLD, x, y, lanes);
  Surface surface = makeSurface(reprojection, position, normal);
#endif
  surface = checkSurface(surface);
  surface.valid = surface.valid && LANE_INDEX < lanes;
  return surface;
}

#endif

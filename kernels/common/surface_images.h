// The caller's images of a surface: normal, world position or view depth.
#ifndef QUELL_COMMON_SURFACE_IMAGES_H
#define QUELL_COMMON_SURFACE_IMAGES_H

#include "common/reprojection.h"
#include "common/surface_params.h"

#define SURFACE_ARGUMENTS __global const uchar *normalData, __global const uchar *positionData

// Pixels whose normal is that of a surface, whatever their position.
QUELL_INLINE intL hasNormal(__global const uchar* normalData, SurfaceParams params, int x, int y, int lanes) {
  const float3L normal = LOAD_PIXELS(NORMAL, normalData, params.normal, x, y, lanes);
  return isSurfaceNormal(dot3(normal, normal)) && LANE_INDEX < lanes;
}

// Lanes from `lanes` on are not valid.
QUELL_INLINE Surface loadSurface(__global const uchar* normalData, __global const uchar* positionData,
                                 SurfaceParams params, ReprojectionParams reprojection, int x, int y,
                                 int lanes) {
  const float3L normal = LOAD_PIXELS(NORMAL, normalData, params.normal, x, y, lanes);
  const float3L position = LOAD_PIXELS(POSITION, positionData, params.position, x, y, lanes);
#if POSITION_IS_DEPTH
  const float3L ray = viewRay(reprojection, TO_FLOAT(x + LANE_INDEX), (floatL)((float)y));
  Surface surface;
  surface.position = scale3(ray, position.x);
  surface.normal = normal;
#else
  Surface surface = makeSurface(reprojection, position, normal);
#endif
  surface = checkSurface(surface);
  surface.valid = surface.valid && LANE_INDEX < lanes;
  return surface;
}

#endif

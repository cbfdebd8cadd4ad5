// Where a surface was in the frame before, and whether a history sample is of it: by the caller's motion vectors and
// object ids as far as there are any, else by matrices and world positions (common/reprojection.h).
//
//   motion  objectId  a history sample counts if
//   no      no        world position and normal are near
//   no      yes       world position and normal are near and the object is the same
//   yes     no        view depth and normal are near
//   yes     yes       the normal is near and the object is the same
//
// World positions cannot be compared where there is motion: the object may have moved. Motion vectors hold for the
// background, too, where only temporal antialiasing uses them.
#ifndef QUELL_COMMON_MOTION_IMAGES_H
#define QUELL_COMMON_MOTION_IMAGES_H

#include "common/motion_params.h"
#include "common/surface_images.h"

#define MOTION_ARGUMENTS __global const uchar *motionData, __global const uchar *objectIdData

// Pixel index in the frame before; see placeInFrame().
QUELL_INLINE intL findPrevious(ReprojectionParams reprojection, __global const uchar* motionData,
                               MotionParams params, PlaneParams planes, Surface surface, int x, int y,
                               int lanes, floatL* xPrev, floatL* yPrev) {
  const floatL column = TO_FLOAT(x + LANE_INDEX);
  const floatL row = (floatL)((float)y);
#if MOTION_FORMAT
  const float3L motion = LOAD_PIXELS(MOTION, motionData, params.motion, x, y, lanes);
  return followMotion(reprojection, column, row, motion, planes.width, planes.height, xPrev, yPrev);
#else
  // Background moves like a point at infinity.
  const float3L target = select3(surface.valid, surface.position, viewRay(reprojection, column, row));
  return reproject(reprojection, target, !surface.valid, planes.width, planes.height, xPrev, yPrev);
#endif
}

// The object of each pixel, bit by bit; 0 without object ids and in lanes from `lanes` on.
QUELL_INLINE intL loadObjectId(__global const uchar* objectIdData, MotionParams params, int x, int y,
                               int lanes) {
#if OBJECTID_FORMAT
  return LOAD_WORDS(OBJECTID, objectIdData, params.objectId, x, y, lanes);
#else
  return (intL)(0);
#endif
}

// Is a history sample of this surface? The object ids point at the tap; `limitSquared` in scene units squared.
QUELL_INLINE intL sameHistory(ReprojectionParams reprojection, Surface surface, intL objectId,
                              float3L positionPrev, float3L normalPrev, __global const int* objectIdPrev,
                              GatherPlan plan, floatL limitSquared) {
#if MOTION_FORMAT && OBJECTID_FORMAT
  const intL same = sameNormal(reprojection, surface, normalPrev);
#elif MOTION_FORMAT
  const intL same =
      sameNormal(reprojection, surface, normalPrev) && nearDepth(reprojection, surface, positionPrev);
#else
  const intL same = sameSurface(reprojection, surface, positionPrev, normalPrev, limitSquared);
#endif
#if OBJECTID_FORMAT
  return same && gatherIntLanes(objectIdPrev, plan) == objectId;
#else
  return same;
#endif
}

#endif

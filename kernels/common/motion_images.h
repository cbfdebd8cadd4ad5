// Where a surface was in the frame before, and whether a history sample is of it: by the caller's motion vectors and
// object ids as far as there are any, else by matrices and world positions (common/reprojection.h).
//
//   motion  objectId  a history sample counts if
//   no      no        world position and normal are near
//   no      yes       world position and normal are near and the object is the same
//   yes     no        view depth and normal are near
//   yes     yes       view depth and normal are near and the object is the same
//
// An object id only ever speaks against a sample: ids may be 0 everywhere, one for a whole figure or one for a material,
// and the wall behind a raised arm must not take the arm's history for its own.
//
// Light does not turn with a surface: along motion vectors that the camera does not explain, history reaches back only
// as far as the surface has turned by a share of the normal limit (Turn).
//
// World positions cannot be compared where there is motion: the object may have moved. Motion vectors hold for the
// background, too, where only temporal antialiasing uses them.
#ifndef QUELL_COMMON_MOTION_IMAGES_H
#define QUELL_COMMON_MOTION_IMAGES_H

#include "common/guides.h"
#include "common/motion_params.h"
#include "common/surface_images.h"

// Pixel index in the frame before; see placeInFrame().
QUELL_INLINE intL findPrevious(FrameImages images, ReprojectionParams reprojection, PlaneParams planes,
                               Surface surface, int x, int y, int lanes, floatL* xPrev, floatL* yPrev) {
  const floatL column = TO_FLOAT(x + LANE_INDEX);
  const floatL row = (floatL)((float)y);
#if MOTION_FORMAT
  const float3L motion = LOAD_IMAGE(motion, MOTION, x, y, lanes);
  return followMotion(reprojection, column, row, motion, planes.width, planes.height, xPrev, yPrev);
#else
  // Background moves like a point at infinity.
  const float3L target = select3(surface.valid, surface.position, viewRay(reprojection, column, row));
  return reproject(reprojection, target, !surface.valid, column, row, planes.width, planes.height, xPrev,
                   yPrev);
#endif
}

// The object of each pixel, bit by bit; 0 without object ids and in lanes from `lanes` on.
QUELL_INLINE intL loadObjectId(FrameImages images, int x, int y, int lanes) {
#if OBJECTID_FORMAT
  return LOAD_WORDS(OBJECTID, images.objectId, images.views.objectId, x, y, lanes);
#else
  return (intL)(0);
#endif
}

// Is a history sample of this surface? The object ids point at the tap; `limitSquared` in scene units squared.
QUELL_INLINE intL sameHistory(ReprojectionParams reprojection, Surface surface, intL objectId,
                              float3L positionPrev, float3L normalPrev, __global const int* objectIdPrev,
                              GatherPlan plan, floatL limitSquared) {
#if MOTION_FORMAT
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

// How far a moving surface turns from frame to frame, and what is left of its history.
typedef struct Turn {
  float3L normal;  // sum over accepted taps
  floatL weight;
  intL moving;  // other than by the camera
  floatL longest;
} Turn;

QUELL_INLINE Turn beginTurn(ReprojectionParams reprojection, PlaneParams planes, Surface surface, int x,
                            int y, floatL xPrev, floatL yPrev) {
  Turn turn;
  turn.normal = splat3(0.0f);
  turn.weight = ZERO_LANES;
  turn.moving = (intL)(0);
  turn.longest = (floatL)(QUELL_MAX_HISTORY_LENGTH);
#if MOTION_FORMAT
  floatL xAtRest, yAtRest;
  const intL inside = reproject(reprojection, surface.position, (intL)(0), TO_FLOAT(x + LANE_INDEX),
                                (floatL)((float)y), planes.width, planes.height, &xAtRest, &yAtRest);
  turn.moving = !(inside && absLanes(xPrev - xAtRest) <= QUELL_MOVING_PX &&
                  absLanes(yPrev - yAtRest) <= QUELL_MOVING_PX);
#endif
  return turn;
}

QUELL_INLINE Turn addNormal(Turn turn, floatL weight, float3L normalPrev) {
#if MOTION_FORMAT
  turn.normal = add3(turn.normal, scale3(normalPrev, weight));
  turn.weight += weight;
#endif
  return turn;
}

// Frames until the mean normal of the history is off by the share of the limit.
QUELL_INLINE Turn endTurn(Turn turn, ReprojectionParams reprojection, Surface surface) {
#if MOTION_FORMAT
  const floatL inverse = 1.0f / (turn.weight > 0.0f ? turn.weight : ONE_LANES);
  const float3L step = subtract3(scale3(turn.normal, inverse), surface.normal);
  const floatL stepSquared = maxLanes(dot3(step, step), (floatL)(QUELL_LEAST_TURN_SQUARED));
  const floatL frames = QUELL_TURN_SHARE * SQRT(reprojection.normalLimitSquared / stepSquared);
  turn.longest = turn.moving ? frames : turn.longest;
#endif
  return turn;
}

// Frames that history stands for where a surface turns; rounded down where they are counted.
QUELL_INLINE floatL effectiveLength(Turn turn, intL length) {
#if MOTION_FORMAT
  return minLanes(TO_FLOAT(length), turn.longest);
#else
  return TO_FLOAT(length);
#endif
}
QUELL_INLINE intL wholeLength(Turn turn, intL length) {
#if MOTION_FORMAT
  return floorLanes(effectiveLength(turn, length));
#else
  return length;
#endif
}

#endif

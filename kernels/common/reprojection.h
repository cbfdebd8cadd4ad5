// Temporal reprojection with a discard test per bilinear tap.
// Paper: Koskela et al. 2019, phase I (preprocessing): "We use bilinear sampling of the history data and do a discard
// test for each pixel separately"; world positions and shading normals decide.
// Departures: positions are camera-relative; limits follow the pixel's footprint unless they are set in scene units;
// the result is rounded to 1/256 pixel; taps also count by their weight as filter taps, 0 where nothing was filtered; motion
// vectors and object ids of the caller (common/motion_images.h).
#ifndef QUELL_COMMON_REPROJECTION_H
#define QUELL_COMMON_REPROJECTION_H

#include "common/image_access.h"
#include "common/planes.h"
#include "common/reprojection_params.h"

typedef struct Surface {
  float3L position;  // relative to this frame's camera, scene units
  float3L normal;    // world space
  intL valid;        // a finite position and a usable normal: neither background nor broken
} Surface;

// Bilinear taps in the order (0,0) (1,0) (0,1) (1,1); bit i of `accepted` belongs to tap i.
typedef struct BilinearTaps {
  GatherPlan plan;  // of tap (0,0); the others lie 1, pitch and pitch + 1 elements further
  floatL weight[4];
  intL inFrame[4];
} BilinearTaps;

QUELL_INLINE floatL affine(QuellFloat4 row, float3L p) {
  return row.x * p.x + row.y * p.y + row.z * p.z + row.w;
}
QUELL_INLINE floatL linear(QuellFloat4 row, float3L p) { return row.x * p.x + row.y * p.y + row.z * p.z; }

// Camera-relative point at view depth 1 through the centre of pixel (x, y).
QUELL_INLINE float3L viewRay(ReprojectionParams params, floatL x, floatL y) {
  float3L ray;
  ray.x = params.rayOrigin.x + x * params.rayX.x + y * params.rayY.x;
  ray.y = params.rayOrigin.y + x * params.rayX.y + y * params.rayY.y;
  ray.z = params.rayOrigin.z + x * params.rayX.z + y * params.rayY.z;
  return ray;
}

// Rounds to 1/256 pixel. |v| must be below 2^23.
QUELL_INLINE floatL roundToSubpixel(floatL v) {
  return TO_FLOAT(floorLanes(v * QUELL_SUBPIXEL_STEPS + 0.5f)) * (1.0f / QUELL_SUBPIXEL_STEPS);
}

// Rounds a pixel index to 1/256 where `wanted` and it lies outside the frame by less than a pixel; elsewhere moves it to
// 0 and returns false.
QUELL_INLINE intL placeInFrame(intL wanted, floatL x, floatL y, int width, int height, floatL* xPlaced,
                               floatL* yPlaced) {
  const intL inside = wanted && touchesFrame(x, y, width, height);
  const floatL xRounded = roundToSubpixel(inside ? x : ZERO_LANES);
  const floatL yRounded = roundToSubpixel(inside ? y : ZERO_LANES);
  // Rounding may reach the border itself, where no tap is left.
  const intL stillInside = inside && xRounded < (float)width && yRounded < (float)height;
  *xPlaced = stillInside ? xRounded : ZERO_LANES;
  *yPlaced = stillInside ? yRounded : ZERO_LANES;
  return stillInside;
}

// A row applied to a position, or to the point at infinity in its direction where `translate` is 0.
QUELL_INLINE floatL applyRow(QuellFloat4 row, float3L position, floatL translate) {
  return linear(row, position) + translate * row.w;
}

// Where the centre of pixel (x, y) was in the frame before, by matrices: it moved as what was sampled in the pixel did,
// wherever in the pixel the sample lay. So neither jitter, nor one of each pixel's own, nor a camera that is off by a
// part of a pixel moves history. Not inside where it is behind a camera. See placeInFrame().
QUELL_INLINE intL reproject(ReprojectionParams params, float3L position, intL isDirection, floatL x, floatL y,
                            int width, int height, floatL* xPrev, floatL* yPrev) {
  const floatL translate = isDirection ? ZERO_LANES : ONE_LANES;
  const floatL w = applyRow(params.clipW, position, translate);
  const floatL wPrev = applyRow(params.clipWPrev, position, translate);
  const floatL inverse = 1.0f / w;
  const floatL inversePrev = 1.0f / wPrev;
  const floatL motionX = applyRow(params.pixelXPrev, position, translate) * inversePrev -
                         applyRow(params.pixelX, position, translate) * inverse;
  const floatL motionY = applyRow(params.pixelYPrev, position, translate) * inversePrev -
                         applyRow(params.pixelY, position, translate) * inverse;
  return placeInFrame(w > 0.0f && wPrev > 0.0f && params.historyValid != 0, x + motionX, y + motionY, width,
                      height, xPrev, yPrev);
}

// The same by a motion vector (previous pixel minus this one, without jitter); not inside where it is NaN or Inf.
QUELL_INLINE intL followMotion(ReprojectionParams params, floatL x, floatL y, float3L motion, int width,
                               int height, floatL* xPrev, floatL* yPrev) {
  const intL usable = isFinite(motion.x) && isFinite(motion.y) && params.historyValid != 0;
  return placeInFrame(usable, x + motion.x * params.motionScaleX, y + motion.y * params.motionScaleY, width,
                      height, xPrev, yPrev);
}

// Bilinear taps at pixel index (x, y), which must lie in [-1, width) x [-1, height).
QUELL_INLINE BilinearTaps bilinearTaps(PlaneParams planes, floatL x, floatL y) {
  BilinearTaps taps;
  const intL column = floorLanes(x);
  const intL row = floorLanes(y);
  const floatL fractionX = x - TO_FLOAT(column);
  const floatL fractionY = y - TO_FLOAT(row);
  taps.weight[0] = (1.0f - fractionX) * (1.0f - fractionY);
  taps.weight[1] = fractionX * (1.0f - fractionY);
  taps.weight[2] = (1.0f - fractionX) * fractionY;
  taps.weight[3] = fractionX * fractionY;
  const intL left = column >= 0 && column < planes.width;
  const intL right = column >= -1 && column < planes.width - 1;
  const intL top = row >= 0 && row < planes.height;
  const intL bottom = row >= -1 && row < planes.height - 1;
  taps.inFrame[0] = left && top;
  taps.inFrame[1] = right && top;
  taps.inFrame[2] = left && bottom;
  taps.inFrame[3] = right && bottom;
  taps.plan = planGather(planeIndexOfLanes(planes, column, row));
  return taps;
}

// The same taps, where isOneRun() says so of their plan.
QUELL_INLINE BilinearTaps tapsInOneRun(BilinearTaps taps) {
  taps.plan = oneRun(taps.plan);
  return taps;
}

// Distance in elements from tap (0,0) to tap i.
QUELL_INLINE int tapOffset(PlaneParams planes, int i) { return (i & 1) + (i >> 1) * planes.pitch; }

// Adds the three planes at the taps in the frame to `sum`; returns their weight.
QUELL_INLINE floatL addTaps(__global const float* from, PlaneParams planes, BilinearTaps taps, float3L* sum) {
  floatL weightSum = ZERO_LANES;
  for (int i = 0; i < 4; ++i) {
    const floatL weight = taps.inFrame[i] ? taps.weight[i] : ZERO_LANES;
    *sum = add3(*sum, scale3(gatherLanes3(from + tapOffset(planes, i), taps.plan, planes.stride), weight));
    weightSum += weight;
  }
  return weightSum;
}
QUELL_INLINE floatL sumTaps(__global const float* from, PlaneParams planes, BilinearTaps taps, float3L* sum) {
  return isOneRun(taps.plan) ? addTaps(from, planes, tapsInOneRun(taps), sum)
                             : addTaps(from, planes, taps, sum);
}

// Is the normal of a history sample that of this surface? World space: a surface that turns keeps its history while it
// turns by less than the limit in a frame.
QUELL_INLINE intL sameNormal(ReprojectionParams params, Surface surface, float3L normalPrev) {
  const float3L step = subtract3(normalPrev, surface.normal);
  return dot3(step, step) <= params.normalLimitSquared;
}

// Relative to this frame's camera instead of the one before.
QUELL_INLINE float3L movedPosition(ReprojectionParams params, float3L positionPrev) {
  positionPrev.x += params.cameraMotion.x;
  positionPrev.y += params.cameraMotion.y;
  positionPrev.z += params.cameraMotion.z;
  return positionPrev;
}

// Is a history sample at this position with this normal the same surface, which does not move? `limitSquared` in scene
// units squared.
QUELL_INLINE intL sameSurface(ReprojectionParams params, Surface surface, float3L positionPrev,
                              float3L normalPrev, floatL limitSquared) {
  const float3L step = subtract3(movedPosition(params, positionPrev), surface.position);
  return dot3(step, step) <= limitSquared && sameNormal(params, surface, normalPrev);
}

// Is a history sample about as far in front of the camera before as this surface would have been at rest? All that can
// be asked of the position of a surface that may move. An orthographic camera has one clip.w for all: always true.
QUELL_INLINE intL nearDepth(ReprojectionParams params, Surface surface, float3L positionPrev) {
  const floatL depth = affine(params.clipWPrev, surface.position);
  const floatL depthPrev = affine(params.clipWPrev, movedPosition(params, positionPrev));
  return absLanes(depthPrev - depth) <= QUELL_DEPTH_STEP_LIMIT * depth;
}

// Largest accepted squared distance between a surface point and its history, scene units squared.
QUELL_INLINE floatL positionLimitSquared(ReprojectionParams params, Surface surface) {
  const floatL depth = affine(params.clipW, surface.position);
  const floatL limit = params.positionLimit + params.positionLimitFootprint * maxLanes(depth, ZERO_LANES);
  return limit * limit;
}

// World position and normal to a camera-relative surface point.
QUELL_INLINE Surface makeSurface(ReprojectionParams params, float3L positionWorld, float3L normal) {
  Surface surface;
  surface.position.x = (positionWorld.x - params.cameraHigh.x) - params.cameraLow.x;
  surface.position.y = (positionWorld.y - params.cameraHigh.y) - params.cameraLow.y;
  surface.position.z = (positionWorld.z - params.cameraHigh.z) - params.cameraLow.z;
  surface.normal = normal;
  return surface;
}

QUELL_INLINE intL isSurfaceNormal(floatL lengthSquared) {
  return lengthSquared >= QUELL_MIN_NORMAL_SQUARED && lengthSquared <= QUELL_MAX_NORMAL_SQUARED;
}

// Marks what can be filtered, makes its normal unit length, and replaces everything else by zeros, which no later stage can stumble over.
QUELL_INLINE Surface checkSurface(Surface surface) {
  const floatL lengthSquared = dot3(surface.normal, surface.normal);
  surface.valid = isFinite3(surface.position) && absLanes(surface.position.x) < QUELL_MAX_POSITION &&
                  absLanes(surface.position.y) < QUELL_MAX_POSITION &&
                  absLanes(surface.position.z) < QUELL_MAX_POSITION && isSurfaceNormal(lengthSquared);
  surface.position = select3(surface.valid, surface.position, splat3(0.0f));
  const floatL inverseLength = 1.0f / SQRT(surface.valid ? lengthSquared : ONE_LANES);
  surface.normal = select3(surface.valid, scale3(surface.normal, inverseLength), splat3(0.0f));
  return surface;
}

#endif

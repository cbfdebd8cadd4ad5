// What a stage needs to find a surface point in the frame before. Derived on the host in double precision from
// quell::Camera (host/core/reprojection.cpp) with the camera position split off, so that nothing in a kernel ever
// sees a coordinate that is large because the scene is far from the world origin.
#ifndef QUELL_COMMON_REPROJECTION_PARAMS_H
#define QUELL_COMMON_REPROJECTION_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct ReprojectionParams {
  // Rows that take a position relative to this frame's camera, (x, y, z, 1), to (a, b, c): the surface point lies at
  // pixel index (a / c, b / c) of this frame (0 is the centre of the first pixel), in front of the camera if c > 0.
  QuellFloat4 pixelX;
  QuellFloat4 pixelY;
  QuellFloat4 clipW;
  // The same of the frame before.
  QuellFloat4 pixelXPrev;
  QuellFloat4 pixelYPrev;
  QuellFloat4 clipWPrev;
  // Position relative to this frame's camera -> distance along the view axis, scene units.
  QuellFloat4 viewDepth;
  // World-space camera position of this frame = high + low (.xyz), so that (position - high) - low keeps float32.
  QuellFloat4 cameraHigh;
  QuellFloat4 cameraLow;
  // Previous camera position minus this one, world space (.xyz).
  QuellFloat4 cameraMotion;
  // Camera-relative point at view depth 1 seen through pixel index (x, y): x * rayX + y * rayY + rayOrigin.
  QuellFloat4 rayX;
  QuellFloat4 rayY;
  QuellFloat4 rayOrigin;
  QuellFloat footprint;      // of a pixel per clip.w, scene units
  QuellFloat positionLimit;  // largest accepted distance, scene units, added to the one in footprints
  QuellFloat positionLimitFootprint;  // largest accepted distance per clip.w, scene units
  QuellFloat normalLimitSquared;      // largest accepted squared difference of unit normals
  QuellFloat motionScaleX;            // motion vectors times this are in pixels
  QuellFloat motionScaleY;
  QuellInt historyValid;  // 0: no frame before this one
} ReprojectionParams;

QUELL_NAMESPACE_END

// Positions at or beyond this distance from the camera (scene units) count as missing: their squares must not
// overflow a float.
#define QUELL_MAX_POSITION 1e18f
// A shorter squared normal marks background, a longer one is not a normal at all; both are passed through. Between them
// every length is normalised: as far as its square neither vanishes nor overflows in a float.
#define QUELL_MIN_NORMAL_SQUARED 1e-36f
#define QUELL_MAX_NORMAL_SQUARED 1e36f
// Reprojected positions are rounded to this fraction of a pixel, as texture units do: a static camera then
// reprojects exactly onto pixel centres, whatever the rounding of the matrices.
#define QUELL_SUBPIXEL_STEPS 256.0f
// With motion vectors: largest change of view depth from one frame to the next, as a share of it.
// Wide: an object may come nearer by a tenth of its distance in a frame; what it uncovers mostly lies farther behind.
#define QUELL_DEPTH_STEP_LIMIT 0.1f

#endif

// temporal_antialiasing: blends the frame with its clamped history, in linear radiance.
// Paper:   Koskela et al. 2019, last step of phase III, after Karis 2014; as in the reference implementation the
//          history is clamped in YCoCg to the mean of the bounds of the 3x3 box and of its cross.
// In:      radiance of the frame (3 planes, [0, 65504]), antialiased radiance of the frame before, pixel index in the frame
//          before, reprojection mask (of the first signal), view depth.
// Out:     antialiased radiance as history (3 planes), for display in the caller's layout, and with ANTIALIAS_LINEAR as it
//          is in the caller's layout.
// Border:  neighbours and taps outside the image are left out and the weights of the taps renormalised.
// Departures: radiance is blended, and encoded for display afterwards, as a pixel's area averages light: the reference
//          blends encoded values and lets the newest frame weigh 0.2, which with a filter as steady as ours blurs more
//          than it smooths (sweep, docs/quell-sweep.md), but less of it at silhouettes, where it shows one surface of two.
//          History is sampled with Catmull-Rom weights, which do not blur it a little more every frame as bilinear ones do,
//          and where the nearest surface of the 3x3 pixels was (Karis 2014), not where the pixel's own was. A pixel that was
//          outside the frame before keeps the newest colour (the reference divides 0 by 0 there), and so does one whose
//          history accumulation has rejected, if it did so for the pixels around as well: alone it is a silhouette, which
//          antialiasing is for. Background keeps the newest colour but next to surfaces, unless the camera's rays are
//          jittered: it is met in the same way in every frame.
#include "common/bicubic.h"
#include "common/display_encoding.h"
#include "common/guides.h"
#include "common/output_images.h"
#include "common/reprojection_params.h"
#include "common/surfaces.h"
#include "temporal_antialiasing_ports.h"

// RGB to YCoCg with gains of 4, 2 and 4 left in; the inverse takes them out.
QUELL_INLINE float3L toYCoCg(float3L rgb) {
  float3L v;
  v.x = rgb.x + 2.0f * rgb.y + rgb.z;
  v.y = rgb.x - rgb.z;
  v.z = 2.0f * rgb.y - rgb.x - rgb.z;
  return v;
}

QUELL_INLINE float3L toRgb(float3L v) {
  float3L rgb;
  const floatL redAndBlue = 0.25f * (v.x - v.z);
  rgb.x = redAndBlue + 0.5f * v.y;
  rgb.y = 0.25f * (v.x + v.z);
  rgb.z = redAndBlue - 0.5f * v.y;
  return rgb;
}

typedef struct Bounds {
  float3L low;
  float3L high;
} Bounds;

QUELL_INLINE Bounds include(Bounds bounds, float3L v) {
  bounds.low.x = minLanes(v.x, bounds.low.x);
  bounds.low.y = minLanes(v.y, bounds.low.y);
  bounds.low.z = minLanes(v.z, bounds.low.z);
  bounds.high.x = maxLanes(v.x, bounds.high.x);
  bounds.high.y = maxLanes(v.y, bounds.high.y);
  bounds.high.z = maxLanes(v.z, bounds.high.z);
  return bounds;
}

typedef struct Neighbourhood {
  Bounds cross;
  Bounds box;
} Neighbourhood;

// Bounds over the 3x3 neighbours. At the border those outside stand back for the centre; `atBorder` is constant, so
// that the inside of the image pays nothing for it.
QUELL_INLINE Neighbourhood boundsAround(__global const float* radiance, PlaneParams planes, int x, int y,
                                        float3L centre, int atBorder) {
  const int index = planeIndex(planes, x, y);
  const intL column = x + LANE_INDEX;
  Bounds cross = {centre, centre};
  Bounds corners = cross;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && dy == 0) continue;
      float3L neighbour = toYCoCg(loadLanes3(radiance, index + dy * planes.pitch + dx, planes.stride));
      if (atBorder) {
        const intL inside = insideFrame(planes, column + dx, (intL)(y + dy));
        neighbour = select3(inside, neighbour, centre);
      }
      if (dx == 0 || dy == 0) {
        cross = include(cross, neighbour);
      } else {
        corners = include(corners, neighbour);
      }
    }
  }
  const Neighbourhood result = {cross, include(include(corners, cross.low), cross.high)};
  return result;
}

QUELL_INLINE floatL depthOrFar(floatL depth, float backgroundDepth) {
  return depth != backgroundDepth ? depth : (floatL)(FLT_MAX);
}

typedef struct PixelPrev {
  floatL x, y;
  intL inFrame;     // whether there is such a place
  intL silhouette;  // whether the pixel or one around is clearly nearer than the other
} PixelPrev;

QUELL_INLINE intL isPrevInFrame(__global const uchar* reprojectionMask, int index) {
  return (loadByteLanes(reprojectionMask + index) & QUELL_PREV_IN_FRAME) != 0;
}

// Where the nearest surface of the 3x3 pixels around would have shown this pixel: a silhouette moves with what is in
// front, on both of its sides. The pixel's own place counts unless a neighbour is clearly nearer; background that
// takes no part has none.
QUELL_INLINE PixelPrev nearestPrev(__global const float* pixelPrev, __global const uchar* reprojectionMask,
                                   __global const float* viewDepth, TemporalAntialiasingParams params, int x,
                                   int y, int atBorder) {
  const PlaneParams planes = params.planes;
  const int index = planeIndex(planes, x, y);
  const intL column = x + LANE_INDEX;
  const floatL own = depthOrFar(loadLanes(viewDepth + index), params.backgroundDepth);
  const intL takesPart = params.antialiasBackground || own != FLT_MAX;
  PixelPrev prev;
  prev.x = takesPart ? loadLanes(pixelPrev + index) : TO_FLOAT(column);
  prev.y = takesPart ? loadLanes(pixelPrev + index + planes.stride) : (floatL)((float)y);
  prev.inFrame = takesPart && isPrevInFrame(reprojectionMask, index);
  prev.silhouette = (intL)(0);
  floatL nearest = own;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const int neighbour = index + dy * planes.pitch + dx;
      floatL depth = depthOrFar(loadLanes(viewDepth + neighbour), params.backgroundDepth);
      if (atBorder) {
        const intL inside = insideFrame(planes, column + dx, (intL)(y + dy));
        depth = inside ? depth : own;
      }
      prev.silhouette = prev.silhouette || depth < QUELL_NEARER * own || own < QUELL_NEARER * depth;
      const intL nearer = depth < QUELL_NEARER * nearest;
      if (!anyLane(nearer)) continue;
      nearest = nearer ? depth : nearest;
      prev.x = nearer ? loadLanes(pixelPrev + neighbour) - (float)dx : prev.x;
      prev.y = nearer ? loadLanes(pixelPrev + neighbour + planes.stride) - (float)dy : prev.y;
      prev.inFrame = nearer ? isPrevInFrame(reprojectionMask, neighbour) : prev.inFrame;
    }
  }
  return prev;
}

// How far the history of a pixel can be trusted.
typedef struct HistoryTrust {
  intL counts;  // not only history of something else was met in the pixel and around
  intL steady;  // most of the 3x3 pixels met their own history; asked at silhouettes only
} HistoryTrust;

QUELL_INLINE HistoryTrust trustHistory(__global const uchar* reprojectionMask, PlaneParams planes, int x,
                                       int y, intL silhouette) {
  const int index = planeIndex(planes, x, y);
  const intL rejected = (loadByteLanes(reprojectionMask + index) & QUELL_HISTORY_REJECTED) != 0;
  HistoryTrust trust = {!rejected, silhouette};
  if (!anyLane(rejected || silhouette)) return trust;
  const intL column = x + LANE_INDEX;
  intL accepted = (intL)(0);
  for (int dy = -1; dy <= 1; ++dy) {
    if (y + dy < 0 || y + dy >= planes.height) continue;
    for (int dx = -1; dx <= 1; ++dx) {
      const intL mask = loadByteLanes(reprojectionMask + index + dy * planes.pitch + dx);
      const intL inside = insideColumns(planes, column + dx);
      accepted += inside && (mask & QUELL_HISTORY_REJECTED) == 0 ? (intL)(1) : (intL)(0);
    }
  }
  trust.counts = trust.counts || accepted > 0;
  trust.steady = silhouette && accepted >= QUELL_STEADY_PIXELS;
  return trust;
}

QUELL_INLINE intL isSlow(PixelPrev prev, int x, int y) {
  return absLanes(prev.x - TO_FLOAT(x + LANE_INDEX)) <= QUELL_STEADY_MOTION_PX &&
         absLanes(prev.y - (float)y) <= QUELL_STEADY_MOTION_PX;
}

QUELL_INLINE floatL clampToMean(floatL v, floatL lowA, floatL lowB, floatL highA, floatL highB) {
  return minLanes(maxLanes(v, 0.5f * (lowA + lowB)), 0.5f * (highA + highB));
}

__kernel void temporal_antialiasing(STAGE_ARGUMENTS(TEMPORAL_ANTIALIASING)
                                        TemporalAntialiasingParams params) {
  BEGIN_PIXELS(params.planes);
  // The stage background has done it.
  if (SKIP && params.antialiasBackground == 0 && isFarBackground(surfaces, planes, x, y)) return;
  const float3L newest = loadLanes3(beforeAntialiasing, index, stride);
  const float3L centre = toYCoCg(newest);
  const int atBorder = x == 0 || y == 0 || x + QUELL_LANES >= planes.width || y == planes.height - 1;
  Neighbourhood around;
  PixelPrev prev;
  if (atBorder) {
    around = boundsAround(beforeAntialiasing, planes, x, y, centre, 1);
    prev = nearestPrev(pixelPrev, reprojectionMask, viewDepth, params, x, y, 1);
  } else {
    around = boundsAround(beforeAntialiasing, planes, x, y, centre, 0);
    prev = nearestPrev(pixelPrev, reprojectionMask, viewDepth, params, x, y, 0);
  }
  const Bounds box = around.box;
  const Bounds cross = around.cross;

  const HistoryTrust trust =
      trustHistory(reprojectionMask, planes, x, y, prev.silhouette && isSlow(prev, x, y));
  const intL hasHistory =
      prev.inFrame && trust.counts && touchesFrame(prev.x, prev.y, planes.width, planes.height);
  const float3L sampled = sampleBicubic(antialiasedPrev, planes, bicubicTaps(planes, prev.x, prev.y));
  float3L history = toYCoCg(sampled);
  history.x = clampToMean(history.x, box.low.x, cross.low.x, box.high.x, cross.high.x);
  history.y = clampToMean(history.y, box.low.y, cross.low.y, box.high.y, cross.high.y);
  history.z = clampToMean(history.z, box.low.z, cross.low.z, box.high.z, cross.high.z);
  const floatL weight = trust.steady ? (floatL)(params.silhouetteWeight) : (floatL)(params.newestWeight);
  const float3L blended = add3(scale3(newest, weight), scale3(toRgb(history), 1.0f - weight));
  const float3L result = clamp3(select3(hasHistory, blended, newest), 0.0f, QUELL_MAX_RADIANCE);
  storeLanes3(result, antialiased, index, stride);
  const int lanes = min(QUELL_LANES, planes.width - x);
#if ANTIALIAS_LINEAR && LINEAR_FORMAT
  STORE_LINEAR(result, linearData, params.outputs.linear, x, y, lanes);
#endif
#if DISPLAY_FORMAT
  STORE_DISPLAY(encodeDisplay(result, params.exposure), displayData, params.outputs.display, x, y, lanes);
#endif
}

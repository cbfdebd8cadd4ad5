// sparse_bilateral: mean over a few pixels scattered over a disc, those of the same surface.
// Paper:   Mara et al. 2017, stages 4 and 7: 50 taps of a cross-bilateral filter whose positions change with every frame.
//          With CELL_RADIUS the disc is the larger the less history is trusted around (stage 7): radius times
//          1 - the least confidence, and some times more where it is low itself.
// In:      irradiance (of the first signal, 3 planes), guides (normals and weights), view depth; with CELL_RADIUS the least
//          confidence of each cell and that around it.
// Out:     filtered irradiance (of the first signal).
// Border:  taps outside the image are left out. A pixel without a sample takes what its neighbours have.
// Departures: taps lie on a sunflower's spiral that turns from frame to frame, at whole pixels; edge stops are those of
//          common/edge_stops.h instead of the distance from the plane; what the radius follows is one for all pixels of a
//          cell of low_confidence.
#include "common/bilateral.h"
#include "common/edge_stops.h"
#include "common/sunflower.h"
#include "common/surfaces.h"
#include "low_confidence_params.h"
#include "sparse_bilateral_ports.h"

#define SUNFLOWER_POINT(x, y) (int2)(x, y),
__constant int2 sunflower[] = {QUELL_SUNFLOWER(SUNFLOWER_POINT)};

// Of the disc around this work-item's pixels.
QUELL_INLINE float radiusAt(SparseBilateralParams params, __global const float* cellConfidence,
                            __global const float* windowConfidence, int x, int y) {
#if CELL_RADIUS
  const int cell =
      planeIndex(params.cells, x / QUELL_CONFIDENCE_CELL_WIDTH, y / QUELL_CONFIDENCE_CELL_HEIGHT);
  const float factor = cellConfidence[cell] < QUELL_LOW_CONFIDENCE ? params.lowFactor : 1.0f;
  return factor * params.radius * (1.0f - windowConfidence[cell]);
#else
  return params.radius;
#endif
}

// Pixels from the centre to a tap, of a disc of `steps` / QUELL_SPARSE_STEPS pixels.
QUELL_INLINE int2 tapOffsetOf(SparseBilateralParams params, int tap, int steps) {
  const int2 point = sunflower[tap];
  const int2 turned = (int2)(params.cosine * point.x - params.sine * point.y,
                             params.sine * point.x + params.cosine * point.y) /
                      QUELL_SUNFLOWER_UNIT;
  const int unit = QUELL_SUNFLOWER_UNIT * QUELL_SPARSE_STEPS;
  return (steps * turned + (unit / 2 * (turned < 0 ? (int2)(-1) : (int2)(1)))) / unit;
}

// Weights of taps by their distance, e^(-2 (tap + 1/2) / 50): the disc holds two deviations of a Gaussian.
#define FIRST_TAP_FALLOFF 0.980198673f
#define NEXT_TAP_FALLOFF 0.960789439f

__kernel void sparse_bilateral(STAGE_ARGUMENTS(SPARSE_BILATERAL) SparseBilateralParams params) {
  BEGIN_PIXELS(params.planes);
  LEAVE_OUT_BACKGROUND(NOTHING_ELSE)
  const FilterCentre centre = loadCentre(guides, viewDepth, viewDepth, planes, params.stops, x, y);
  __global const float* weights = guides + QUELL_GUIDE_WEIGHT * stride;
  const floatL own = loadLanes(weights + index);
  BilateralSums sums = {scale3(loadLanes3(sparseInput, index, stride), own), own};
  const float radius = radiusAt(params, cellConfidence, windowConfidence, x, y);
  const int steps = (int)(min(radius, QUELL_SPARSE_MOST_RADIUS) * (float)QUELL_SPARSE_STEPS);
  float falloff = FIRST_TAP_FALLOFF;
  for (int tap = 0; tap < QUELL_SUNFLOWER_POINTS; ++tap) {
    const int2 offset = tapOffsetOf(params, tap, steps);
    const int column = x + offset.x;
    const int row = y + offset.y;
    if ((offset.x != 0 || offset.y != 0) && row >= 0 && row < planes.height && column + QUELL_LANES > 0 &&
        column < planes.width) {
      const int at = planeIndex(planes, column, row);
      const float inverseDistance = 1.0f / sqrt((float)(offset.x * offset.x + offset.y * offset.y));
      const float3L normal = loadLanes3(guides + QUELL_GUIDE_NORMAL * stride, at, stride);
      const floatL penalty =
          surfacePenalty(centre, params.stops, normal, loadLanes(viewDepth + at), inverseDistance);
      sums = addBilateralTaps(sums, sparseInput, weights, planes, column, at, penalty, falloff);
    }
    falloff *= NEXT_TAP_FALLOFF;
  }
  storeLanes3(bilateralMean(sums), sparseOutput, index, stride);
}

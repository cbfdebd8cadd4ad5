// separable_bilateral: mean over the pixels of a row or of a column that show the same surface, the wider the rougher it is.
// Paper:   Mara et al. 2017, stages 9 and 10: a Gaussian of sigma = 7 roughness^0.1 + epsilon pixels, separated into rows and
//          columns.
// In:      irradiance (3 planes per signal, of which those of QUELL_SIGNAL are filtered), guides (normals and weights), view
//          depth and, with ROUGHNESS_STOP, roughness; without it surfaces count as perfectly rough.
// Out:     of this signal, filtered irradiance.
// Border:  taps outside the image are left out. A pixel without a sample takes what its neighbours have.
// Departures: edge stops are those of common/edge_stops.h instead of the distance from the plane.
#include "common/bilateral.h"
#include "common/edge_stops.h"
#include "common/surfaces.h"
#include "separable_bilateral_ports.h"

__kernel void separable_bilateral(STAGE_ARGUMENTS(SEPARABLE_BILATERAL) SeparableBilateralParams params) {
  BEGIN_PIXELS(params.planes);
  LEAVE_OUT_BACKGROUND(NOTHING_ELSE)
  __global const float* values = separableInput + 3 * QUELL_SIGNAL * stride;
  __global const float* weights = guides + (QUELL_GUIDE_WEIGHT + QUELL_SIGNAL) * stride;
  const FilterCentre centre = loadCentre(guides, viewDepth, roughness, planes, params.stops, x, y);
#if ROUGHNESS_STOP
  const floatL sigma =
      params.sigma * powr(maxLanes(centre.roughness, ZERO_LANES), (floatL)(QUELL_SEPARABLE_POWER)) +
      QUELL_SEPARABLE_LEAST_SIGMA;
#else
  const floatL sigma = (floatL)(params.sigma + QUELL_SEPARABLE_LEAST_SIGMA);
#endif
  const floatL rate = 0.5f / (sigma * sigma);
  BilateralSums sums = {splat3(0.0f), ZERO_LANES};
  for (int tap = -QUELL_SEPARABLE_REACH; tap <= QUELL_SEPARABLE_REACH; ++tap) {
    const int column = params.alongRows ? x + tap : x;
    const int row = params.alongRows ? y : y + tap;
    if (row < 0 || row >= planes.height || column + QUELL_LANES <= 0 || column >= planes.width) continue;
    const int at = planeIndex(planes, column, row);
    floatL penalty = rate * (float)(tap * tap);
    if (tap != 0) {
      const float3L normal = loadLanes3(guides + QUELL_GUIDE_NORMAL * stride, at, stride);
      penalty +=
          surfacePenalty(centre, params.stops, normal, loadLanes(viewDepth + at), 1.0f / (float)abs(tap));
#if ROUGHNESS_STOP
      penalty += roughnessPenalty(centre, loadLanes(roughness + at));
#endif
    }
    sums = addBilateralTaps(sums, values, weights, planes, column, at, penalty, 1.0f);
  }
  storeLanes3(bilateralMean(sums), separableOutput + 3 * QUELL_SIGNAL * stride, index, stride);
}

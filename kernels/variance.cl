// variance: variance of the luminance of each signal, over time where the history is long enough, else over space.
// Paper:   Schied et al. 2017, section 4.2, after Flatval 2020, ch. 3.2.2: second moment minus squared first moment;
//          "when few samples have been accumulated at a given pixel, its variance is instead computed using its
//          neighbors by a bilateral filter with feature weights", 7x7 pixels.
// In:      moments of luminance (2 planes per signal), history length (bytes per signal), guides, view depth; with
//          STOP_LUMINANCE or FIREFLIES irradiance (3 planes per signal).
// Out:     variance (1 plane per signal), >= 0; with OF_MEAN that of the accumulated irradiance: divided by the
//          history length. 0 in background next to surfaces.
//          With STOP_LUMINANCE the luminance of the irradiance over 3x3 pixels (1 plane per signal), for the edge stops of
//          the first iterations of atrous: one pixel's is too noisy to tell an edge.
//          With FIREFLIES the weights of the guides, less where one sample of rare brightness makes the light (1 plane per
//          signal; see common/fireflies.h). 0 in background.
// Border:  taps outside the image are left out.
// Departures: the spatial estimate is raised by temporalFrames / history length: the moments of one frame know less.
#include "common/edge_stops.h"
#include "common/fireflies.h"
#include "common/luminance.h"
#include "common/surfaces.h"
#include "variance_ports.h"

typedef struct MomentSums {
  floatL first;
  floatL second;
  floatL weight;
} MomentSums;

// Weighted moments over the window around each pixel.
QUELL_INLINE MomentSums spatialMoments(__global const float* moments, __global const float* weights,
                                       __global const float* guides, __global const float* viewDepth,
                                       VarianceParams params, int x, int y) {
  const PlaneParams planes = params.planes;
  const int stride = planes.stride;
  const FilterCentre centre = loadCentre(guides, viewDepth, viewDepth, planes, params.stops, x, y);
  MomentSums sums;
  sums.first = ZERO_LANES;
  sums.second = ZERO_LANES;
  sums.weight = ZERO_LANES;
  for (int dy = -QUELL_VARIANCE_RADIUS; dy <= QUELL_VARIANCE_RADIUS; ++dy) {
    if (y + dy < 0 || y + dy >= planes.height) continue;
    for (int dx = -QUELL_VARIANCE_RADIUS; dx <= QUELL_VARIANCE_RADIUS; ++dx) {
      const int index = planeIndex(planes, x + dx, y + dy);
      const float inverseDistance = dx == 0 && dy == 0 ? 0.0f : 1.0f / sqrt((float)(dx * dx + dy * dy));
      const intL column = x + dx + LANE_INDEX;
      const intL inside = insideColumns(planes, column);
      const floatL penalty = surfacePenalty(centre, params.stops,
                                            loadLanes3(guides + QUELL_GUIDE_NORMAL * stride, index, stride),
                                            loadLanes(viewDepth + index), inverseDistance);
      const floatL weight = inside ? weightOfPenalty(penalty) * loadLanes(weights + index) : ZERO_LANES;
      sums.first += weight * loadLanes(moments + QUELL_MOMENT_FIRST * stride + index);
      sums.second += weight * loadLanes(moments + QUELL_MOMENT_SECOND * stride + index);
      sums.weight += weight;
    }
  }
  return sums;
}

QUELL_INLINE floatL momentsToVariance(floatL first, floatL second) {
  return maxLanes(second - first * first, ZERO_LANES);
}

#if STOP_LUMINANCE
// Luminance over 3x3 pixels with the weights of a binomial, of what has a sample. `atBorder` is constant, so that the
// inside of the image pays nothing for it.
QUELL_INLINE floatL prefilterLuminance(__global const float* irradiance, __global const float* weights,
                                       PlaneParams planes, int x, int y, int atBorder) {
  floatL sum = ZERO_LANES;
  floatL weightSum = ZERO_LANES;
  for (int dy = -1; dy <= 1; ++dy) {
    if (atBorder && (y + dy < 0 || y + dy >= planes.height)) continue;
    for (int dx = -1; dx <= 1; ++dx) {
      const int index = planeIndex(planes, x + dx, y + dy);
      const intL inside = atBorder ? insideColumns(planes, x + dx + LANE_INDEX) : TRUE_LANES;
      const float binomial = (float)((2 - abs(dx)) * (2 - abs(dy)));
      const floatL weight = inside ? binomial * loadLanes(weights + index) : ZERO_LANES;
      sum += weight * luminance(loadLanes3(irradiance, index, planes.stride));
      weightSum += weight;
    }
  }
  return sum / (weightSum > 0.0f ? weightSum : ONE_LANES);
}
#endif

#if FIREFLIES
// Pixels of which one sample may make the light: as far as the moments tell, whose newest sample weighs at least
// momentsLeastWeight, or because lately they have had far less.
QUELL_INLINE intL suspectFireflies(floatL first, floatL second, floatL luminance, intL length,
                                   VarianceParams params) {
  const floatL samples = minLanes(TO_FLOAT(length), (floatL)(params.momentsFrames));
  const intL oneSample = second > QUELL_FIREFLY_SHARE_OF_SAMPLES * samples * first * first;
  const intL faded = luminance > params.fireflyRatio * first;
  return length >= QUELL_FIREFLY_LEAST_HISTORY && (oneSample || faded);
}
#endif

// What filters must find in background: no weight, and next to surfaces no variance.
QUELL_INLINE void storeNoVariance(VarianceParams params, int x, int y, __global float* variance,
                                  __global float* tapWeights, __global const uchar* surfaces) {
  const PlaneParams planes = params.planes;
  const int stride = planes.stride;
  const int index = planeIndex(planes, x, y);
  ZERO_NEXT_TO_SURFACES(variance, QUELL_SIGNALS)
#if FIREFLIES
  storeZeroWeights(tapWeights, index, stride);
#endif
}

__kernel void variance(STAGE_ARGUMENTS(VARIANCE) VarianceParams params) {
  BEGIN_PIXELS(params.planes);
  LEAVE_OUT_BACKGROUND(storeNoVariance(params, x, y, variance, tapWeights, surfaces))
#if STOP_LUMINANCE
  const int atBorder = x == 0 || y == 0 || x + QUELL_LANES >= planes.width || y == planes.height - 1;
#endif
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    __global const float* signalMoments = moments + QUELL_MOMENT_PLANES * s * stride;
    __global const float* weights = guides + (QUELL_GUIDE_WEIGHT + s) * stride;
#if STOP_LUMINANCE
    const floatL prefiltered =
        atBorder ? prefilterLuminance(irradiance + 3 * s * stride, weights, planes, x, y, 1)
                 : prefilterLuminance(irradiance + 3 * s * stride, weights, planes, x, y, 0);
    storeLanes(prefiltered, stopLuminance + s * stride + index);
#endif
    const floatL first = loadLanes(signalMoments + QUELL_MOMENT_FIRST * stride + index);
    const floatL second = loadLanes(signalMoments + QUELL_MOMENT_SECOND * stride + index);
    floatL result = momentsToVariance(first, second);
    const intL length = loadByteLanes(historyLength + s * stride + index);
    intL isShort = length < params.temporalFrames && x + LANE_INDEX < planes.width;
    // Background has no history either: a second look keeps it from the costly path.
    if (anyLane(isShort)) isShort = isShort && loadLanes(weights + index) > 0.0f;
    if (anyLane(isShort)) {
      const MomentSums sums = spatialMoments(signalMoments, weights, guides, viewDepth, params, x, y);
      const floatL inverse = 1.0f / (sums.weight > 0.0f ? sums.weight : ONE_LANES);
      const floatL spatial = momentsToVariance(sums.first * inverse, sums.second * inverse);
      const floatL raised = (float)params.temporalFrames / TO_FLOAT(maxLanesInt(length, (intL)(1)));
      result = isShort ? spatial * raised : result;
    }
#if FIREFLIES
    __global const float* signal = irradiance + 3 * s * stride;
    const floatL own = luminance(loadLanes3(signal, index, stride));
    const intL suspects = suspectFireflies(first, second, own, length, params);
    const Ring ring = {signal, weights, planes, x, y};
    storeLanes(loadLanes(weights + index) * fireflyShare(suspects, own, params.fireflyRatio, ring),
               tapWeights + s * stride + index);
#endif
#if OF_MEAN
    result /= TO_FLOAT(maxLanesInt(length, (intL)(1)));
#endif
    storeLanes(result, variance + s * stride + index);
  }
}

// atrous: one iteration of the edge-avoiding a-trous wavelet filter, and of the variance along with it.
// Paper:   Dammertz et al. 2010 (5x5 B3 spline, taps 2^i pixels apart); Schied et al. 2017, eq. (2) to (5), after
//          Flatval 2020, ch. 3.2.1 and 3.2.2: edge stops on depth, normal and luminance, the latter in standard
//          deviations of the 3x3-prefiltered variance; variance is filtered with squared weights.
// In:      irradiance (3 planes per signal), its variance of luminance (1 plane per signal; with VARIANCE), guides, view
//          depth and, with ROUGHNESS_STOP, roughness; with STOP_LUMINANCE the luminance that the stops compare (1 plane per
//          signal; see variance.cl), with TAP_WEIGHTS the weights of pixels, instead of those of the guides: once filtered
//          a firefly is one no more, and may count again.
// Out:     irradiance and, with VARIANCE and where the params ask for it, variance, filtered; that is 0 in background next
//          to surfaces.
// Signals: share the penalties of the surface; each has its own weight, luminance and variance. The roughness stop is
//          for the glossy signal, or for the only one.
// Taps:    5x5, or with TAP_RADIUS 1 3x3 with a linear spline: a third of the work, and as wide after one more iteration.
//          Where the params say so without the four corners, which have the least weight.
// Border:  taps outside the image are left out and the weights renormalised. A pixel without a sample takes what its
//          neighbours have, whatever their luminance.
// Departures: see common/edge_stops.h; with STOP_LUMINANCE the penalty of luminance is squared.
#include "atrous_ports.h"
#include "common/edge_stops.h"
#include "common/luminance.h"
#include "common/surfaces.h"

#if TAP_RADIUS == 2
// B3 spline: 3/8, 1/4, 1/16 for taps 0, 1 and 2 away.
QUELL_INLINE float splineWeight(int tap) {
  return tap == 0 ? 0.375f : (tap == 1 || tap == -1) ? 0.25f : 0.0625f;
}
#else
// B1 spline: 1/2 and 1/4 for taps 0 and 1 away.
QUELL_INLINE float splineWeight(int tap) { return tap == 0 ? 0.5f : 0.25f; }
#endif

QUELL_INLINE int isCorner(int tapX, int tapY) { return abs(tapX) == TAP_RADIUS && abs(tapY) == TAP_RADIUS; }

typedef struct FilterSums {
  float3L irradiance;
  floatL variance;
  floatL weight;
  floatL luminance;         // of the centre
  floatL inverseLuminance;  // 1 / tolerated difference
} FilterSums;

QUELL_INLINE FilterSums addFiltered(FilterSums sums, float3L irradiance, floatL variance, floatL weight) {
  sums.irradiance.x += irradiance.x * weight;
  sums.irradiance.y += irradiance.y * weight;
  sums.irradiance.z += irradiance.z * weight;
#if VARIANCE
  sums.variance += weight * weight * variance;
#endif
  sums.weight += weight;
  return sums;
}

#if VARIANCE
// 3x3 binomial filter of the variance; neighbours outside the image stand back for the centre.
QUELL_INLINE floatL prefilterVariance(__global const float* variance, PlaneParams planes, int x, int y,
                                      int atBorder) {
  const int index = planeIndex(planes, x, y);
  const intL column = x + LANE_INDEX;
  const floatL centre = loadLanes(variance + index);
  floatL sum = 0.25f * centre;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && dy == 0) continue;
      floatL value = loadLanes(variance + index + dy * planes.pitch + dx);
      if (atBorder) {
        const intL inside = insideFrame(planes, column + dx, (intL)(y + dy));
        value = inside ? value : centre;
      }
      sum += (dx == 0 || dy == 0 ? 0.125f : 0.0625f) * value;
    }
  }
  return sum;
}
#endif

// The planes that taps are read from.
typedef struct FilterPlanes {
  __global const float* irradiance;
  __global const float* variance;
  __global const float* guides;
  __global const float* viewDepth;
  __global const float* roughness;
  __global const float* stopLuminance;
  __global const float* weights;  // one plane a signal
} FilterPlanes;

// The luminance that edge stops compare: that of the value, or with STOP_LUMINANCE its mean around the pixel.
QUELL_INLINE floatL stopLuminanceOf(FilterPlanes from, float3L value, int index) {
#if STOP_LUMINANCE
  return loadLanes(from.stopLuminance + index);
#else
  return luminance(value);
#endif
}

// Means over several pixels are nearly normally distributed: what is within their noise costs next to nothing then.
QUELL_INLINE floatL luminancePenalty(FilterSums sums, floatL tapLuminance) {
  const floatL step = absLanes(tapLuminance - sums.luminance) * sums.inverseLuminance;
  return STOP_LUMINANCE ? step * step : step;
}

// 1 / sqrt(x^2 + y^2) for the offsets of a 5x5 filter.
QUELL_INLINE float inverseDistance(int x, int y) {
  const int squared = x * x + y * y;
  return squared == 1   ? 1.0f
         : squared == 2 ? 0.707106781f
         : squared == 4 ? 0.5f
         : squared == 5 ? 0.447213595f
                        : 0.353553391f;
}

// Adds the tap (tapX, tapY) of all signals; `index` is its element in the planes, `inside` its lanes in the image.
QUELL_INLINE void addTap(FilterSums sums[QUELL_SIGNALS], FilterCentre centre, FilterPlanes from,
                         AtrousParams params, int tapX, int tapY, int index, intL inside) {
  const int stride = params.planes.stride;
  const floatL penalty = surfacePenalty(
      centre, params.stops, loadLanes3(from.guides + QUELL_GUIDE_NORMAL * stride, index, stride),
      loadLanes(from.viewDepth + index), inverseDistance(tapX, tapY) * params.inverseStep);
  const float spline = splineWeight(tapX) * splineWeight(tapY);
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const float3L value = loadLanes3(from.irradiance + 3 * s * stride, index, stride);
    floatL signalPenalty =
        penalty + luminancePenalty(sums[s], stopLuminanceOf(from, value, s * stride + index));
#if ROUGHNESS_STOP
    if (s == QUELL_SIGNALS - 1) signalPenalty += roughnessPenalty(centre, loadLanes(from.roughness + index));
#endif
    const floatL weight =
        weightOfPenalty(signalPenalty) * (spline * loadLanes(from.weights + s * stride + index));
#if VARIANCE
    const floatL variance = loadLanes(from.variance + s * stride + index);
#else
    const floatL variance = ZERO_LANES;
#endif
    sums[s] = addFiltered(sums[s], value, variance, inside ? weight : ZERO_LANES);
  }
}

// Adds the tap (tapX, tapY), if it is one. `atBorder` is constant, so that the inside of the image pays nothing for it.
QUELL_INLINE void addTapIfAny(FilterSums sums[QUELL_SIGNALS], FilterCentre centre, FilterPlanes from,
                              AtrousParams params, int x, int y, int tapX, int tapY, int atBorder) {
  const PlaneParams planes = params.planes;
  const int column = x + tapX * params.step;
  const int row = y + tapY * params.step;
  if (tapX == 0 && tapY == 0) return;
  if (isCorner(tapX, tapY) && !params.corners) return;
  if (atBorder && (row < 0 || row >= planes.height)) return;
  if (atBorder && (column + QUELL_LANES <= 0 || column >= planes.width)) return;
  const intL inside = atBorder ? insideColumns(planes, column + LANE_INDEX) : TRUE_LANES;
  addTap(sums, centre, from, params, tapX, tapY, planeIndex(planes, column, row), inside);
}

// Adds the taps of one row. Written out: every weight and offset of a tap is then a constant.
QUELL_INLINE void addTapRow(FilterSums sums[QUELL_SIGNALS], FilterCentre centre, FilterPlanes from,
                            AtrousParams params, int x, int y, int tapY) {
#pragma unroll
  for (int tapX = -TAP_RADIUS; tapX <= TAP_RADIUS; ++tapX)
    addTapIfAny(sums, centre, from, params, x, y, tapX, tapY, 0);
}

// Adds all taps at the border, where few pixels are: written out they would be long to compile.
QUELL_INLINE void addTapsAtBorder(FilterSums sums[QUELL_SIGNALS], FilterCentre centre, FilterPlanes from,
                                  AtrousParams params, int x, int y) {
#pragma unroll 1
  for (int tapY = -TAP_RADIUS; tapY <= TAP_RADIUS; ++tapY) {
#pragma unroll 1
    for (int tapX = -TAP_RADIUS; tapX <= TAP_RADIUS; ++tapX)
      addTapIfAny(sums, centre, from, params, x, y, tapX, tapY, 1);
  }
}

#if ROUGHNESS_STOP
// How much narrower the stop on luminance becomes: reflections in what is nearly a mirror have edges of their own.
QUELL_INLINE floatL sharpening(floatL roughness, AtrousParams params) {
  return 1.0f + params.sharpening * maxLanes(1.0f - roughness * params.inverseSharpRoughness, ZERO_LANES);
}
#endif

__kernel void atrous(STAGE_ARGUMENTS(ATROUS) AtrousParams params) {
  BEGIN_PIXELS(params.planes);
  // The prefilter of the variance reads background next to surfaces, in both buffers that iterations write by turns.
  LEAVE_OUT_BACKGROUND(if (VARIANCE && params.filtersVariance && params.iteration <= 2)
                           ZERO_NEXT_TO_SURFACES(filteredVariance, QUELL_SIGNALS))
#if TAP_WEIGHTS
  __global const float* weights = tapWeights;
#else
  __global const float* weights = guides + QUELL_GUIDE_WEIGHT * stride;
#endif
  const FilterPlanes from = {irradiance, variance, guides, viewDepth, roughness, stopLuminance, weights};
  const int reach = TAP_RADIUS * params.step;
  const int atBorder =
      x < reach || y < reach || x + QUELL_LANES + reach > planes.width || y + reach >= planes.height;

  const FilterCentre centre = loadCentre(guides, viewDepth, roughness, planes, params.stops, x, y);
  FilterSums sums[QUELL_SIGNALS];
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const float3L value = loadLanes3(irradiance + 3 * s * stride, index, stride);
    const floatL weight = loadLanes(weights + s * stride + index);
    sums[s].luminance = stopLuminanceOf(from, value, s * stride + index);
    floatL deviation = ONE_LANES;
    floatL ownVariance = ZERO_LANES;
#if VARIANCE
    deviation = SQRT(prefilterVariance(variance + s * stride, planes, x, y, atBorder));
    ownVariance = loadLanes(variance + s * stride + index);
#endif
    sums[s].inverseLuminance =
        weight > 0.0f ? 1.0f / (params.luminanceSigma * deviation + QUELL_LEAST_LUMINANCE_STEP) : ZERO_LANES;
#if ROUGHNESS_STOP
    if (s == QUELL_SIGNALS - 1) sums[s].inverseLuminance *= sharpening(centre.roughness, params);
#endif
    sums[s].irradiance = splat3(0.0f);
    sums[s].variance = ZERO_LANES;
    sums[s].weight = ZERO_LANES;
    sums[s] = addFiltered(sums[s], value, ownVariance, splineWeight(0) * splineWeight(0) * weight);
  }
  if (atBorder) {
    addTapsAtBorder(sums, centre, from, params, x, y);
  } else {
    // In the order of the border, so that sums do not depend on where a group of lanes ends.
#if TAP_RADIUS == 2
    addTapRow(sums, centre, from, params, x, y, -2);
#endif
    addTapRow(sums, centre, from, params, x, y, -1);
    addTapRow(sums, centre, from, params, x, y, 0);
    addTapRow(sums, centre, from, params, x, y, 1);
#if TAP_RADIUS == 2
    addTapRow(sums, centre, from, params, x, y, 2);
#endif
  }
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const floatL inverse = sums[s].weight > QUELL_LEAST_WEIGHT_SUM ? 1.0f / sums[s].weight : ZERO_LANES;
    storeLanes3(scale3(sums[s].irradiance, inverse), filteredIrradiance + 3 * s * stride, index, stride);
#if VARIANCE
    if (params.filtersVariance)
      storeLanes(sums[s].variance * inverse * inverse, filteredVariance + s * stride + index);
#endif
  }
}

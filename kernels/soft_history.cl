// soft_history: blends newest samples into a history that is trusted the less the farther it lies from where it should.
// Paper:   Mara et al. 2017, stages 3 and 8, eq. (11): confidence falls smoothly with the distance between the expected and
//          the found position; history is clamped to the distribution of the newest samples in the 3x3 pixels around.
// In:      irradiance of this frame (3 planes per signal, of which those of QUELL_SIGNAL count), guides (the weights alone),
//          positions of this frame and of the one before, the pixel index and the accepted taps there, history length, and
//          the history of the frame before (3 planes per signal).
// Out:     of this signal, blended irradiance (3 planes) and confidence (1 plane, 0 to 1).
// Border:  pixels outside the image and those without a sample are left out of the distribution.
// Departures: eq. (11) as printed rises with the distance; here it falls, as its text says. The confidence is that without h,
//          which is multiplied once. Mean and deviation stand for the distribution. Taps of other surfaces
//          are left out; the confidence is that of the others. Where the parameters say so the weight of history is at
//          most that of a mean over its frames, 1 - 1 / n, so that the first sample does not count for fifty frames.
#include "common/guides.h"
#include "common/reprojection.h"
#include "common/surfaces.h"
#include "soft_history_ports.h"

// What the newest samples around a pixel sum up to.
typedef struct Distribution {
  float3L sum;
  float3L squares;
  floatL count;
} Distribution;

QUELL_INLINE Distribution addNewest(Distribution sums, float3L value, intL counts) {
  value = select3(counts, value, splat3(0.0f));
  sums.sum = add3(sums.sum, value);
  sums.squares = add3(sums.squares, multiply3(value, value));
  sums.count += counts ? ONE_LANES : ZERO_LANES;
  return sums;
}

// The pointers are those of the signal.
QUELL_INLINE Distribution newestAround(__global const float* newest, __global const float* weights,
                                       PlaneParams planes, int x, int y) {
  Distribution sums = {splat3(0.0f), splat3(0.0f), ZERO_LANES};
  for (int dy = -1; dy <= 1; ++dy) {
    if (y + dy < 0 || y + dy >= planes.height) continue;
    for (int dx = -1; dx <= 1; ++dx) {
      const int index = planeIndex(planes, x + dx, y + dy);
      const intL counts = insideColumns(planes, x + dx + LANE_INDEX) && loadLanes(weights + index) > 0.0f;
      sums = addNewest(sums, loadLanes3(newest, index, planes.stride), counts);
    }
  }
  return sums;
}

QUELL_INLINE floatL clampToDistribution(floatL history, floatL sum, floatL squares, floatL inverseCount,
                                        float sigma) {
  const floatL mean = sum * inverseCount;
  const floatL reach = sigma * SQRT(maxLanes(squares * inverseCount - mean * mean, ZERO_LANES));
  return minLanes(maxLanes(history, mean - reach), mean + reach);
}

QUELL_INLINE float3L clampHistory(float3L history, Distribution newest, float sigma) {
  const floatL inverse = 1.0f / maxLanes(newest.count, ONE_LANES);
  float3L clamped;
  clamped.x = clampToDistribution(history.x, newest.sum.x, newest.squares.x, inverse, sigma);
  clamped.y = clampToDistribution(history.y, newest.sum.y, newest.squares.y, inverse, sigma);
  clamped.z = clampToDistribution(history.z, newest.sum.z, newest.squares.z, inverse, sigma);
  return select3(newest.count > 0.0f, clamped, history);
}

// Eq. (11): 1 up to the near distance, 0 from the far one on.
QUELL_INLINE floatL confidenceAt(floatL distance, floatL nearest, floatL farthest) {
  const floatL t = clampLanes((farthest - distance) / (farthest - nearest), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

__kernel void soft_history(STAGE_ARGUMENTS(SOFT_HISTORY) SoftHistoryParams params) {
  BEGIN_PIXELS(params.planes);
  LEAVE_OUT_BACKGROUND(NOTHING_ELSE)
  __global const float* newest = irradiance + 3 * QUELL_SIGNAL * stride;
  __global const float* weights = guides + (QUELL_GUIDE_WEIGHT + QUELL_SIGNAL) * stride;
  __global const float* history = historyPrev + 3 * QUELL_SIGNAL * stride;
  const int masks = VIRTUAL ? 0 : QUELL_SIGNAL;

  const float3L position = loadLanes3(positions, index, stride);
  const floatL depth = maxLanes(affine(params.reprojection.clipW, position), ZERO_LANES);
  const floatL nearest = params.nearDistance + params.nearFootprint * depth;
  const floatL farthest = params.farDistance + params.farFootprint * depth;
  const intL accepted = loadByteLanes(tapMask + masks * stride + index);
  const BilinearTaps taps =
      bilinearTaps(planes, loadLanes(pixelPrev + index), loadLanes(pixelPrev + index + stride));
  float3L sum = splat3(0.0f);
  floatL trust = ZERO_LANES;
  floatL met = ZERO_LANES;
  for (int i = 0; i < 4; ++i) {
    const int offset = tapOffset(planes, i);
    const float3L found =
        movedPosition(params.reprojection, gatherLanes3(positionsPrev + offset, taps.plan, stride));
    const float3L step = subtract3(found, position);
    const floatL distance = params.trustsMotion ? ZERO_LANES : SQRT(dot3(step, step));
    const floatL confidenceHere = confidenceAt(distance, nearest, farthest);
    const floatL surface = (accepted & QUELL_TAP_ACCEPTED(i)) != 0 ? taps.weight[i] : ZERO_LANES;
    const floatL weight = surface * confidenceHere;
    const float3L value = gatherLanes3(history + offset, taps.plan, stride);
    sum = add3(sum, select3(weight > 0.0f, scale3(value, weight), splat3(0.0f)));
    trust += weight;
    met += surface;
  }
  const intL hasHistory = trust > 0.0f;
  float3L old = scale3(sum, 1.0f / (hasHistory ? trust : ONE_LANES));
  if (params.clampSigma > 0.0f)
    old = clampHistory(old, newestAround(newest, weights, planes, x, y), params.clampSigma);

  const floatL length =
      maxLanes(TO_FLOAT(loadByteLanes(historyLength + QUELL_SIGNAL * stride + index)), ONE_LANES);
  const floatL ofMean = params.meanFirst ? 1.0f - 1.0f / length : ONE_LANES;
  const floatL most = minLanes((floatL)(params.hysteresis), ofMean);
  const floatL sure = hasHistory ? minLanes(trust / met, ONE_LANES) : ZERO_LANES;
  const floatL kept = most * sure;
  const float3L here = loadLanes3(newest, index, stride);
  storeLanes3(add3(scale3(here, 1.0f - kept), select3(hasHistory, scale3(old, kept), splat3(0.0f))),
              blended + 3 * QUELL_SIGNAL * stride, index, stride);
  storeLanes(sure, confidence + QUELL_SIGNAL * stride + index);
}

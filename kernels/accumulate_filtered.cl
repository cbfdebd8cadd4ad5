// accumulate_filtered: blends the fitted irradiance into the filtered history.
// Paper:   Koskela et al. 2019, phase III (post-processing, second temporal accumulation): motion and discard
//          decisions of the first accumulation are reused; weight of the new frame max(1 / n, leastWeight).
// In:      fitted irradiance (3 planes per signal), filtered irradiance of the frame before, pixel index in the frame
//          before, reprojection mask and history length (per signal). Out: filtered irradiance (3 planes per signal).
#include "accumulate_filtered_ports.h"
#include "common/guides.h"
#include "common/reprojection.h"
#include "common/surfaces.h"

// The pointers are those of the signal, moved to the pixel; `history` to its plane.
QUELL_INLINE void accumulateSignal(__global const float* fitted, __global const float* history,
                                   BilinearTaps taps, intL mask, floatL length, __global float* filtered,
                                   AccumulateFilteredParams params) {
  const PlaneParams planes = params.planes;
  const float3L newest = loadLanes3(fitted, 0, planes.stride);
  float3L sum = splat3(0.0f);
  for (int i = 0; i < 4; ++i) taps.inFrame[i] = (mask & QUELL_TAP_ACCEPTED(i)) != 0;
  const floatL weightSum = sumTaps(history, planes, taps, &sum);
  const intL hasHistory = weightSum > 0.0f;
  const float3L mean = scale3(sum, 1.0f / (hasHistory ? weightSum : ONE_LANES));
  const floatL cumulative = 1.0f / maxLanes(length, ONE_LANES);
  const floatL blend = hasHistory ? maxLanes(cumulative, (floatL)(params.leastWeight)) : ONE_LANES;
  storeLanes3(add3(scale3(newest, blend), scale3(mean, 1.0f - blend)), filtered, 0, planes.stride);
}

__kernel void accumulate_filtered(STAGE_ARGUMENTS(ACCUMULATE_FILTERED) AccumulateFilteredParams params) {
  BEGIN_PIXELS(params.planes);
  LEAVE_OUT_BACKGROUND(NOTHING_ELSE)
  const BilinearTaps taps =
      bilinearTaps(planes, loadLanes(pixelPrev + index), loadLanes(pixelPrev + index + stride));
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const int plane = 3 * s * stride;
    const int bytes = s * stride + index;
    accumulateSignal(fitted + plane + index, filteredPrev + plane, taps,
                     loadByteLanes(reprojectionMask + bytes), TO_FLOAT(loadByteLanes(historyLength + bytes)),
                     filtered + plane + index, params);
  }
}

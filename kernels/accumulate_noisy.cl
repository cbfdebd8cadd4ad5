// accumulate_noisy: reprojects the accumulated irradiance of the frame before and blends the new sample into it.
// Paper:   Koskela et al. 2019, phase I (preprocessing, temporal accumulation of the noisy 1 spp data).
// In:      the caller's radiance, normal, position (or view depth), optional emission, albedo and gloss colour, any
//          layout; irradiance, history length and guides of the frame before.
// Out:     irradiance (3 planes), history length (bytes), guides (7 planes, see the params), pixel index in the frame
//          before (2 planes) and the reprojection mask (bytes).
// Weight:  of the new sample: max(1 / (n + 1), leastWeight), n = bilinear history length, rounded: a cumulative mean
//          first, an exponential one later.
// Departures: history is double-buffered (the reference reads and overwrites it in one kernel); a NaN or Inf in
//          radiance or emission is a missing sample: the pixel keeps its history, or becomes a hole that the fit
//          fills; one in position or normal makes it pass through; positions are
//          relative to the camera; see common/reprojection.h and common/demodulation.h for the rest.
#include "accumulate_noisy_params.h"
#include "common/material.h"
#include "common/reprojection.h"

typedef struct Sample {
  float3L irradiance;
  floatL weight;
  intL present;
} Sample;

QUELL_INLINE Sample loadSample(__global const uchar* radianceData, __global const uchar* emissionData,
                               __global const uchar* albedoData, __global const uchar* glossColorData,
                               AccumulateNoisyParams params, int x, int y, int lanes) {
  const Material material =
      LOAD_MATERIAL(radianceData, emissionData, albedoData, glossColorData, params, x, y, lanes);
  Sample sample;
#if DEMODULATED
  sample.irradiance = cleanSignal(material.radiance, splat3(0.0f), material.finite);
  sample.weight = ONE_LANES;
#else
  const float3L signal = cleanSignal(material.radiance, material.emission, material.finite);
  sample.irradiance = demodulate(signal, material.factor, &sample.weight);
#endif
  sample.present = material.finite && sample.weight > 0.0f;
  return sample;
}

QUELL_INLINE Surface loadSurface(__global const uchar* normalData, __global const uchar* positionData,
                                 AccumulateNoisyParams params, int x, int y, int lanes) {
  const float3L normal = LOAD_PIXELS(NORMAL, normalData, params.normal, x, y, lanes);
  const float3L position = LOAD_PIXELS(POSITION, positionData, params.position, x, y, lanes);
#if POSITION_IS_DEPTH
  const float3L ray = viewRay(params.reprojection, TO_FLOAT(x + LANE_INDEX), (floatL)((float)y));
  Surface surface;
  surface.position = scale3(ray, position.x);
  surface.normal = normal;
#else
  Surface surface = makeSurface(params.reprojection, position, normal);
#endif
  surface = checkSurface(surface);
  surface.valid = surface.valid && LANE_INDEX < lanes;
  return surface;
}

__kernel void accumulate_noisy(__global const uchar* radianceData, __global const uchar* emissionData,
                               __global const uchar* albedoData, __global const uchar* glossColorData,
                               __global const uchar* normalData, __global const uchar* positionData,
                               __global const float* irradiancePrev, __global const uchar* historyLengthPrev,
                               __global const float* guidesPrev, __global float* irradiance,
                               __global uchar* historyLength, __global float* guides,
                               __global float* pixelPrev, __global uchar* reprojectionMask,
                               AccumulateNoisyParams params) {
  const PlaneParams planes = params.planes;
  const int x = (int)get_global_id(0) * QUELL_LANES;
  const int y = (int)get_global_id(1);
  if (x >= planes.width || y >= planes.height) return;
  const int lanes = min(QUELL_LANES, planes.width - x);
  const int index = planeIndex(planes, x, y);

  const Sample sample =
      loadSample(radianceData, emissionData, albedoData, glossColorData, params, x, y, lanes);
  const Surface surface = loadSurface(normalData, positionData, params, x, y, lanes);

  // Background moves like a point at infinity: only TAA uses where it was.
  const float3L ray = viewRay(params.reprojection, TO_FLOAT(x + LANE_INDEX), (floatL)((float)y));
  const float3L target = select3(surface.valid, surface.position, ray);
  floatL xPrev, yPrev;
  const intL inside =
      reproject(params.reprojection, target, !surface.valid, planes.width, planes.height, &xPrev, &yPrev);
  const BilinearTaps taps = bilinearTaps(planes, xPrev, yPrev);
  const floatL limitSquared = positionLimitSquared(params.reprojection, surface);

  float3L sum = splat3(0.0f);
  floatL lengthSum = ZERO_LANES;
  floatL weightSum = ZERO_LANES;
  intL mask = inside ? (intL)(QUELL_PREV_IN_FRAME) : (intL)(0);
  const intL wanted = inside && surface.valid;
  if (anyLane(wanted)) {
    for (int i = 0; i < 4; ++i) {
      const int offset = tapOffset(planes, i);
      const float3L positionPrev =
          gatherLanes3(guidesPrev + QUELL_GUIDE_POSITION * planes.stride + offset, taps.plan, planes.stride);
      const float3L normalPrev =
          gatherLanes3(guidesPrev + QUELL_GUIDE_NORMAL * planes.stride + offset, taps.plan, planes.stride);
      const floatL weightPrev =
          gatherLanes(guidesPrev + QUELL_GUIDE_WEIGHT * planes.stride + offset, taps.plan);
      const floatL weight = taps.weight[i] * weightPrev;
      const intL accepted = wanted && taps.inFrame[i] && weight > 0.0f &&
                            sameSurface(params.reprojection, surface, positionPrev, normalPrev, limitSquared);
      const float3L tap = gatherLanes3(irradiancePrev + offset, taps.plan, planes.stride);
      const floatL length = gatherByteLanes(historyLengthPrev + offset, taps.plan);
      const floatL used = accepted ? weight : ZERO_LANES;
      sum = add3(sum, scale3(tap, used));
      lengthSum += used * length;
      weightSum += used;
      mask = mask | (accepted ? (intL)(QUELL_TAP_ACCEPTED(i)) : (intL)(0));
    }
  }

  const intL hasHistory = weightSum > 0.0f;
  const floatL inverseWeight = 1.0f / (hasHistory ? weightSum : ONE_LANES);
  const float3L history = scale3(sum, inverseWeight);
  const intL lengthPrev = floorLanes(lengthSum * inverseWeight + 0.5f);
  const intL present = sample.present && surface.valid;
  const floatL cumulative = 1.0f / (TO_FLOAT(lengthPrev) + 1.0f);
  const floatL blend =
      present ? (hasHistory ? maxLanes(cumulative, (floatL)(params.leastWeight)) : ONE_LANES) : ZERO_LANES;
  float3L blended = add3(scale3(sample.irradiance, blend), scale3(history, 1.0f - blend));
  blended = select3(present || hasHistory, blended, splat3(0.0f));
  const intL length =
      minLanesInt(lengthPrev + (present ? (intL)(1) : (intL)(0)), (intL)(QUELL_MAX_HISTORY_LENGTH));
  const floatL storedWeight = (present || hasHistory) ? (present ? sample.weight : ONE_LANES) : ZERO_LANES;

  storeLanes3(blended, irradiance, index, planes.stride);
  storeByteLanes(length, historyLength + index);
  storeLanes3(surface.position, guides + QUELL_GUIDE_POSITION * planes.stride, index, planes.stride);
  storeLanes3(surface.normal, guides + QUELL_GUIDE_NORMAL * planes.stride, index, planes.stride);
  storeLanes(storedWeight, guides + QUELL_GUIDE_WEIGHT * planes.stride + index);
  storeLanes(xPrev, pixelPrev + index);
  storeLanes(yPrev, pixelPrev + index + planes.stride);
  storeByteLanes(mask, reprojectionMask + index);
}

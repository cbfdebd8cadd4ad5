// accumulate_noisy: reprojects the accumulated irradiance of the frame before and blends the new sample into it.
// Paper:   Koskela et al. 2019, phase I (preprocessing, temporal accumulation of the noisy 1 spp data); with MOMENTS
//          also the temporal accumulation of Schied et al. 2017 (Flatval 2020, ch. 3.2: the second moment "is blended
//          and accumulated just like the light samples").
// In:      the caller's radiance (or diffuse and glossy radiance), normal, position (or view depth), optional emission,
//          albedo, gloss colour, roughness, F0, motion vectors and object ids, any layout; the table of F_beta where
//          light is divided by it; irradiance, history length, guides, moments and object ids of the frame before.
// Out:     per signal: irradiance (3 planes), history length (bytes), reprojection mask (bytes) and, with MOMENTS, the
//          moments of luminance (2 planes); guides (see common/guides.h); pixel index in the frame before (2 planes);
//          F_beta (3 planes) where light is divided by it;
//          with INNOVATION the newest sample (3 planes, -1 where it is missing) and how far it is from the history
//          (2 planes, see common/innovation.h; 0 where one of them is missing); with SKIP `surfaces` (see
//          common/surfaces.h);
//          with FILTER_GUIDES view depth (1 plane) and, where the caller has it, roughness (1 plane); where the caller
//          has them, object ids (1 plane).
// Weight:  of the new sample: max(1 / (n + 1), leastWeight), n = bilinear history length, rounded and limited: a
//          cumulative mean first, an exponential one later.
// Departures: history is double-buffered (the reference reads and overwrites it in one kernel); a NaN or Inf in
//          radiance or emission is a missing sample: the pixel keeps its history, or becomes a hole that the filter
//          fills; one in position or normal makes it pass through, as emitters do (the weight 0); positions are
//          relative to the camera; see common/reprojection.h, common/motion_images.h, common/demodulation.h and
//          common/emitters.h for the rest.
#include "accumulate_noisy_ports.h"
#include "common/f_beta_images.h"
#include "common/filter_input.h"
#include "common/luminance.h"
#include "common/motion_images.h"
#include "common/surface_images.h"
#include "common/surfaces.h"

typedef struct History {
  float3L irradiance;
  floatL firstMoment;
  floatL secondMoment;
  floatL length;
  floatL weight;
} History;

QUELL_INLINE History emptyHistory(void) {
  History history;
  history.irradiance = splat3(0.0f);
  history.firstMoment = ZERO_LANES;
  history.secondMoment = ZERO_LANES;
  history.length = ZERO_LANES;
  history.weight = ZERO_LANES;
  return history;
}

// Adds one bilinear tap; the pointers are those of the signal, moved to the tap.
QUELL_INLINE History addHistoryTap(History history, floatL weight, GatherPlan plan, int stride,
                                   __global const float* irradiance, __global const float* moments,
                                   __global const uchar* length) {
  history.irradiance = add3(history.irradiance, scale3(gatherLanes3(irradiance, plan, stride), weight));
  history.length += weight * gatherByteLanes(length, plan);
  history.weight += weight;
#if MOMENTS
  history.firstMoment += weight * gatherLanes(moments + QUELL_MOMENT_FIRST * stride, plan);
  history.secondMoment += weight * gatherLanes(moments + QUELL_MOMENT_SECOND * stride, plan);
#endif
  return history;
}

// Planes of the frame before.
typedef struct PreviousPlanes {
  __global const float* guides;
  __global const float* irradiance;
  __global const float* moments;
  __global const uchar* historyLength;
  __global const int* objectIds;
} PreviousPlanes;

// Adds tap i, where it is `wanted` and shows this surface, to the history of every signal that it has a sample of.
QUELL_INLINE void addSurfaceTap(PreviousPlanes previous, AccumulateNoisyParams params, Surface surface,
                                intL objectId, floatL limitSquared, intL wanted, BilinearTaps taps, int i,
                                History* history, intL* mask, intL* met, Turn* turn) {
  const int stride = params.planes.stride;
  const int offset = tapOffset(params.planes, i);
  const float3L position =
      gatherLanes3(previous.guides + QUELL_GUIDE_POSITION * stride + offset, taps.plan, stride);
  const float3L normal =
      gatherLanes3(previous.guides + QUELL_GUIDE_NORMAL * stride + offset, taps.plan, stride);
  const intL same = wanted && taps.inFrame[i] &&
                    sameHistory(params.reprojection, surface, objectId, position, normal,
                                previous.objectIds + offset, taps.plan, limitSquared);
  *turn = addNormal(*turn, same ? taps.weight[i] : ZERO_LANES, normal);
  UNROLL_ON_GPU
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const floatL weight =
        taps.weight[i] * gatherLanes(previous.guides + (QUELL_GUIDE_WEIGHT + s) * stride + offset, taps.plan);
    const intL accepted = same && weight > 0.0f;
    *met = *met || accepted;
    history[s] = addHistoryTap(history[s], accepted ? weight : ZERO_LANES, taps.plan, stride,
                               previous.irradiance + 3 * s * stride + offset,
                               previous.moments + QUELL_MOMENT_PLANES * s * stride + offset,
                               previous.historyLength + s * stride + offset);
    mask[s] = mask[s] | (accepted ? (intL)(QUELL_TAP_ACCEPTED(i)) : (intL)(0));
  }
}

QUELL_INLINE History normaliseHistory(History history) {
  const floatL inverse = 1.0f / (history.weight > 0.0f ? history.weight : ONE_LANES);
  history.irradiance = scale3(history.irradiance, inverse);
  history.length *= inverse;
#if MOMENTS
  history.firstMoment *= inverse;
  history.secondMoment *= inverse;
#endif
  return history;
}

#if MOMENTS
QUELL_INLINE floatL mixLanes(floatL history, floatL newest, floatL weight) {
  return newest * weight + history * (1.0f - weight);
}
#endif

#if INNOVATION
// A difference of a sample from its history, without rounding.
QUELL_INLINE floatL innovationOf(floatL difference, floatL least, intL comparable) {
  return comparable && absLanes(difference) > least ? difference : ZERO_LANES;
}
#endif

// Blends a sample into its history (whose length is 0 where there is none), stores both, and returns the pixel's weight
// as a filter tap. The pointers are those of the signal, moved to the pixel.
QUELL_INLINE floatL storeBlended(History history, Turn turn, Sample sample, intL mostFrames,
                                 AccumulateNoisyParams params, __global float* irradiance,
                                 __global float* moments, __global uchar* length,
                                 __global float* newestIrradiance, __global float* innovation) {
  const int stride = params.planes.stride;
  const intL hasHistory = history.weight > 0.0f && !sample.bare;
  const intL frames = minLanesInt(floorLanes(history.length + 0.5f), mostFrames - 1);
  const intL lengthPrev = wholeLength(turn, frames);
  const floatL cumulative = 1.0f / (effectiveLength(turn, frames) + 1.0f);
  const floatL blend = sample.present ? maxLanes(cumulative, (floatL)(params.leastWeight)) : ZERO_LANES;
  float3L blended = add3(scale3(sample.irradiance, blend), scale3(history.irradiance, 1.0f - blend));
  blended = select3(sample.present || hasHistory, blended, splat3(0.0f));
  storeLanes3(blended, irradiance, 0, stride);
#if INNOVATION
  // Irradiance is never negative: -1 stands for a missing sample.
  storeLanes3(select3(sample.present, sample.irradiance, splat3(-1.0f)), newestIrradiance, 0, stride);
  const intL comparable = sample.present && hasHistory;
  const float3L step = subtract3(sample.irradiance, history.irradiance);
  const floatL least = QUELL_LEAST_INNOVATION * luminance(sample.irradiance);
  storeLanes(innovationOf(luminance(step), least, comparable),
             innovation + QUELL_INNOVATION_LUMINANCE * stride);
  storeLanes(innovationOf(step.x - step.z, least, comparable),
             innovation + QUELL_INNOVATION_CHROMINANCE * stride);
#endif
#if MOMENTS
  const floatL newest = luminance(sample.irradiance);
  const floatL momentsBlend =
      sample.present ? maxLanes(cumulative, (floatL)(params.momentsLeastWeight)) : ZERO_LANES;
  const floatL first = mixLanes(history.firstMoment, newest, momentsBlend);
  const floatL second = mixLanes(history.secondMoment, newest * newest, momentsBlend);
  storeLanes(sample.present || hasHistory ? first : ZERO_LANES, moments + QUELL_MOMENT_FIRST * stride);
  storeLanes(sample.present || hasHistory ? second : ZERO_LANES, moments + QUELL_MOMENT_SECOND * stride);
#endif
  storeByteLanes((hasHistory ? lengthPrev : (intL)(0)) + (sample.present ? (intL)(1) : (intL)(0)), length);
  return sample.present || hasHistory ? ONE_LANES : ZERO_LANES;
}

#if SKIP
// What others must find in pixels without a surface: nothing to filter, no history; see common/surfaces.h. Where the
// background was matters to temporal_antialiasing alone, and to it only if it takes part there.
QUELL_INLINE void storeBackground(AccumulateNoisyParams params, FrameImages images, int x, int y, int lanes,
                                  __global float* guides, __global uchar* historyLength,
                                  __global float* pixelPrev, __global uchar* reprojectionMask,
                                  __global float* viewDepth) {
  const int stride = params.planes.stride;
  const int index = planeIndex(params.planes, x, y);
  storeBackgroundWeights(guides, index, stride);
  for (int s = 0; s < QUELL_SIGNALS; ++s) storeByteLanes((intL)(0), historyLength + s * stride + index);
#if MOTION_FORMAT
  // How far a surface has turned is told by normals alone: those of earlier frames must not take part.
  storeLanes3(splat3(0.0f), guides + QUELL_GUIDE_NORMAL * stride, index, stride);
#endif
#if FILTER_GUIDES
  storeLanes((floatL)(params.reprojection.viewDepth.w), viewDepth + index);
#endif
  if (params.antialiasBackground == 0) {
    // Antialiasing of surfaces next to it asks whether they alone have lost their history.
    storeByteLanes((intL)(0), reprojectionMask + index);
    return;
  }
  Surface none;
  none.position = splat3(0.0f);
  none.normal = none.position;
  none.valid = none.position.x != 0.0f;
  floatL xPrev, yPrev;
  const intL inside =
      findPrevious(images, params.reprojection, params.planes, none, x, y, lanes, &xPrev, &yPrev);
  storeLanes(xPrev, pixelPrev + index);
  storeLanes(yPrev, pixelPrev + index + stride);
  storeByteLanes(inside ? (intL)(QUELL_PREV_IN_FRAME) : (intL)(0), reprojectionMask + index);
}
#endif

__kernel void accumulate_noisy(STAGE_ARGUMENTS(ACCUMULATE_NOISY) AccumulateNoisyParams params) {
  BEGIN_PIXELS(params.planes);
  BIND_FRAME_IMAGES(ACCUMULATE_NOISY, params.images);
  const int lanes = min(QUELL_LANES, planes.width - x);
#if SKIP
  if (!markSurface(images, surfaces, planes, x, y, lanes)) {
    storeBackground(params, images, x, y, lanes, guides, historyLength, pixelPrev, reprojectionMask,
                    viewDepth);
    return;
  }
#endif
  Surface surface = loadSurface(images, params.reprojection, x, y, lanes);
  const float3L fBetaHere =
      loadFBeta(images, fBetaTable, params.reprojection, surface.position, surface.normal, x, y, lanes);
  keepFBeta(fBetaHere, fBeta, index, stride);
  const Material material = loadMaterial(images, fBetaHere, x, y, lanes);
  surface.normal = filteredNormal(surface.normal, material.signals[0], surface.valid);
  const intL emits = findEmitters(images, planes, material.signals[0], x, y);

  floatL xPrev, yPrev;
  const intL inside = findPrevious(images, params.reprojection, planes, surface, x, y, lanes, &xPrev, &yPrev);
  const intL objectId = loadObjectId(images, x, y, lanes);
  const BilinearTaps taps = bilinearTaps(planes, xPrev, yPrev);
  const floatL limitSquared = positionLimitSquared(params.reprojection, surface);
  const PreviousPlanes previous = {guidesPrev, irradiancePrev, momentsPrev, historyLengthPrev, objectIdsPrev};

  History history[QUELL_SIGNALS];
  intL mask[QUELL_SIGNALS];
  UNROLL_ON_GPU
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    history[s] = emptyHistory();
    mask[s] = inside ? (intL)(QUELL_PREV_IN_FRAME) : (intL)(0);
  }
  const intL wanted = inside && surface.valid;
  intL met = (intL)(0);  // lanes that have a history in any signal
  Turn turn = beginTurn(params.reprojection, planes, surface, x, y, xPrev, yPrev);
  if (anyLane(wanted)) {
    // Written out the usual case keeps its sums in registers; written out as well the other one is long to compile.
    if (isOneRun(taps.plan)) {
#pragma unroll
      for (int i = 0; i < 4; ++i)
        addSurfaceTap(previous, params, surface, objectId, limitSquared, wanted, tapsInOneRun(taps), i,
                      history, mask, &met, &turn);
    } else {
      for (int i = 0; i < 4; ++i)
        addSurfaceTap(previous, params, surface, objectId, limitSquared, wanted, taps, i, history, mask, &met,
                      &turn);
    }
  }

  turn = endTurn(turn, params.reprojection, surface);
  // What does not move on the screen is not blurred by resampling, however old.
  const intL still = xPrev == TO_FLOAT(x + LANE_INDEX) && yPrev == (floatL)((float)y);
  const intL mostFrames = still ? (intL)(params.mostFramesStill) : (intL)(params.mostFrames);
  UNROLL_ON_GPU
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const Sample sample =
        makeSample(material.signals[s], s == 0 ? emits : (intL)(0), history[s].weight > 0.0f, surface.valid);
    const floatL weight = storeBlended(
        normaliseHistory(history[s]), turn, sample, mostFrames, params, irradiance + 3 * s * stride + index,
        moments + QUELL_MOMENT_PLANES * s * stride + index, historyLength + s * stride + index,
        newestIrradiance + 3 * s * stride + index, innovation + QUELL_INNOVATION_PLANES * s * stride + index);
    storeLanes(weight, guides + (QUELL_GUIDE_WEIGHT + s) * stride + index);
    storeByteLanes(mask[s] | (wanted && !met ? (intL)(QUELL_HISTORY_REJECTED) : (intL)(0)),
                   reprojectionMask + s * stride + index);
  }
  storeLanes3(surface.position, guides + QUELL_GUIDE_POSITION * stride, index, stride);
  storeLanes3(surface.normal, guides + QUELL_GUIDE_NORMAL * stride, index, stride);
#if OBJECTID_FORMAT
  storeIntLanes(objectId, objectIds + index);
#endif
  storeLanes(xPrev, pixelPrev + index);
  storeLanes(yPrev, pixelPrev + index + stride);
#if FILTER_GUIDES
  storeLanes(affine(params.reprojection.viewDepth, surface.position), viewDepth + index);
#if ROUGHNESS_FORMAT
  storeLanes(loadRoughness(images, x, y, lanes), roughness + index);
#endif
#endif
}

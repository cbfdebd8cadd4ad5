// follow_change: gives the newest sample more weight in its history where the light has changed, and shortens that
//          history to what it is still worth.
// Source:  ours; the weights are those of change_weight, interpolated between the centres of tiles.
// In:      weights (1 float per tile and signal), newest irradiance (3 planes per signal; -1 where there was no
//          sample: such a pixel stays as it is).
// In/out:  irradiance (3 planes per signal), moments of luminance (2 planes per signal) and history length (bytes per
//          signal) as accumulate_noisy left them. Where the weight there was as large, nothing is touched.
// Border:  weights beyond the last centre of a tile stay constant.
#include "common/luminance.h"
#include "common/planes.h"
#include "common/surfaces.h"
#include "common/tiles.h"
#include "follow_change_ports.h"

// Whether one of the tiles around the pixels from x on has more than the least weight: where the light is still, the
// answer costs less than interpolating.
QUELL_INLINE int anyTileAbove(__global const float* weights, ChangeParams params, TileMix mix, int x) {
  const int first = max((x - QUELL_TILE / 2) / QUELL_TILE, 0);
  const int last = min((x + QUELL_LANES - 1 + QUELL_TILE / 2) / QUELL_TILE, params.tilesX - 1);
  float largest = 0.0f;
  for (int column = first; column <= last; ++column)
    largest = max(largest, max(weights[mix.top + column], weights[mix.bottom + column]));
  return largest > params.leastWeight;
}

// Share of the way from what was blended with weight `given` to the newest sample that makes it the weight `wanted`.
QUELL_INLINE floatL shareFor(floatL wanted, floatL given) {
  const floatL raised = maxLanes(wanted, given);
  return given < 1.0f ? (raised - given) / (1.0f - given) : ZERO_LANES;
}

QUELL_INLINE floatL towards(floatL value, floatL newest, floatL share) {
  return value + share * (newest - value);
}

__kernel void follow_change(STAGE_ARGUMENTS(FOLLOW_CHANGE) ChangeParams params) {
  BEGIN_PIXELS(params.planes);
  LEAVE_OUT_BACKGROUND(NOTHING_ELSE)
  const TileMix mix = mixTiles(params.tilesX, params.tilesY, x, y);
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    if (!anyTileAbove(changeWeights + s * params.tilesX * params.tilesY, params, mix, x)) continue;
    const floatL wanted = mixedValue(changeWeights + s * params.tilesX * params.tilesY, mix);
    if (!anyLane(wanted > params.leastWeight)) continue;
    __global uchar* length = historyLength + s * stride + index;
    const intL frames = loadByteLanes(length);
    const floatL cumulative = 1.0f / TO_FLOAT(maxLanesInt(frames, (intL)(1)));
    const floatL given = maxLanes(cumulative, (floatL)(params.leastWeight));
    const float3L newest = loadLanes3(newestIrradiance + 3 * s * stride, index, stride);
    const intL changed = wanted > given && newest.x >= 0.0f;
    if (!anyLane(changed)) continue;
    const floatL share = changed ? shareFor(wanted, given) : ZERO_LANES;
    float3L blended = loadLanes3(irradiance + 3 * s * stride, index, stride);
    blended.x = towards(blended.x, newest.x, share);
    blended.y = towards(blended.y, newest.y, share);
    blended.z = towards(blended.z, newest.z, share);
    storeLanes3(blended, irradiance + 3 * s * stride, index, stride);

    const floatL momentsGiven = maxLanes(cumulative, (floatL)(params.momentsLeastWeight));
    const floatL momentsShare = changed ? shareFor(wanted, momentsGiven) : ZERO_LANES;
    const floatL newestLuminance = luminance(newest);
    __global float* first = moments + (QUELL_MOMENT_PLANES * s + QUELL_MOMENT_FIRST) * stride + index;
    __global float* second = moments + (QUELL_MOMENT_PLANES * s + QUELL_MOMENT_SECOND) * stride + index;
    storeLanes(towards(loadLanes(first), newestLuminance, momentsShare), first);
    storeLanes(towards(loadLanes(second), newestLuminance * newestLuminance, momentsShare), second);
    storeByteLanes(changed ? floorLanes(1.0f / maxLanes(wanted, given) + 0.5f) : frames, length);
  }
}

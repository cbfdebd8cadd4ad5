// Catmull-Rom samples of history: what is resampled every frame blurs with bilinear taps, and hardly with these.
// Paper: Catmull and Rom 1974 with tension 1/2; without the four corners of the 4x4 taps, whose weights are below .006
// (Jimenez 2016, Filmic SMAA), renormalised.
#ifndef QUELL_COMMON_BICUBIC_H
#define QUELL_COMMON_BICUBIC_H

#include "common/planes.h"

// Taps of columns and rows -1, 0, 1, 2 from that of the plan; weights of taps outside the frame are 0.
typedef struct BicubicTaps {
  GatherPlan plan;
  floatL weightX[4];
  floatL weightY[4];
} BicubicTaps;

// Weights of one axis at `t` of [0, 1] from pixel `first` to the next one, of `size` pixels.
QUELL_INLINE void catmullRomWeights(floatL t, intL first, int size, floatL* weight) {
  weight[0] = first >= 1 ? t * (-0.5f + t * (1.0f - 0.5f * t)) : ZERO_LANES;
  weight[1] = 1.0f + t * t * (-2.5f + 1.5f * t);
  weight[2] = t * (0.5f + t * (2.0f - 1.5f * t));
  weight[3] = first + 2 < size ? t * t * (-0.5f + 0.5f * t) : ZERO_LANES;
}

// Taps at pixel index (x, y); outside the frame the pixel at its border counts, as renormalised bilinear taps have it.
QUELL_INLINE BicubicTaps bicubicTaps(PlaneParams planes, floatL x, floatL y) {
  BicubicTaps taps;
  const floatL insideX = clampLanes(x, 0.0f, (float)(planes.width - 1));
  const floatL insideY = clampLanes(y, 0.0f, (float)(planes.height - 1));
  // The last pixel is the end of the step before it, so that no tap lies further outside than planes have margins.
  const intL column = minLanesInt(floorLanes(insideX), (intL)(max(planes.width - 2, 0)));
  const intL row = minLanesInt(floorLanes(insideY), (intL)(max(planes.height - 2, 0)));
  catmullRomWeights(insideX - TO_FLOAT(column), column, planes.width, taps.weightX);
  catmullRomWeights(insideY - TO_FLOAT(row), row, planes.height, taps.weightY);
  taps.plan = planGather(planeIndexOfLanes(planes, column, row));
  return taps;
}

// Whether every lane falls on a pixel, as all do where nothing moves: then one tap is all.
QUELL_INLINE int onPixels(BicubicTaps taps) {
  return !anyLane(taps.weightX[1] != 1.0f || taps.weightY[1] != 1.0f);
}

// One row of taps times `weightY`: the outer ones only where `outer` says so, which is a constant.
QUELL_INLINE void addBicubicRow(__global const float* row, int stride, BicubicTaps taps, floatL weightY,
                                int outer, float3L* sum, floatL* weightSum) {
  for (int i = 1 - outer; i < 3 + outer; ++i) {
    const floatL weight = taps.weightX[i] * weightY;
    *sum = add3(*sum, scale3(gatherLanes3(row + i - 1, taps.plan, stride), weight));
    *weightSum += weight;
  }
}

QUELL_INLINE float3L addBicubicTaps(__global const float* from, PlaneParams planes, BicubicTaps taps) {
  float3L sum = splat3(0.0f);
  floatL weightSum = ZERO_LANES;
  addBicubicRow(from - planes.pitch, planes.stride, taps, taps.weightY[0], 0, &sum, &weightSum);
  addBicubicRow(from, planes.stride, taps, taps.weightY[1], 1, &sum, &weightSum);
  addBicubicRow(from + planes.pitch, planes.stride, taps, taps.weightY[2], 1, &sum, &weightSum);
  addBicubicRow(from + 2 * planes.pitch, planes.stride, taps, taps.weightY[3], 0, &sum, &weightSum);
  return scale3(sum, 1.0f / weightSum);
}

// The same for taps in any place. Few pixels come here, and written out it is long to compile.
QUELL_INLINE float3L addScatteredTaps(__global const float* from, PlaneParams planes, BicubicTaps taps) {
  floatL sums[3] = {ZERO_LANES, ZERO_LANES, ZERO_LANES};
  floatL weightSum = ZERO_LANES;
#pragma unroll 1
  for (int row = 0; row < 4; ++row) {
    const int outer = row == 1 || row == 2;
#pragma unroll 1
    for (int column = 1 - outer; column < 3 + outer; ++column) {
      const floatL weight = taps.weightX[column] * taps.weightY[row];
      __global const float* tap = from + (row - 1) * planes.pitch + column - 1;
      weightSum += weight;
#pragma unroll 1
      for (int c = 0; c < 3; ++c) {
        // In two steps, as addBicubicRow() has them: the same bits.
        const floatL weighted = gatherLanes(tap + c * planes.stride, taps.plan) * weight;
        sums[c] += weighted;
      }
    }
  }
  const float3L sum = {sums[0], sums[1], sums[2]};
  return scale3(sum, 1.0f / weightSum);
}

// The three planes `from` at the taps. May be below 0 and above all values around: whoever asks clamps it.
QUELL_INLINE float3L sampleBicubic(__global const float* from, PlaneParams planes, BicubicTaps taps) {
  if (!isOneRun(taps.plan)) return addScatteredTaps(from, planes, taps);
  taps.plan = oneRun(taps.plan);
  return onPixels(taps) ? gatherLanes3(from, taps.plan, planes.stride) : addBicubicTaps(from, planes, taps);
}

#endif

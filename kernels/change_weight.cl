// change_weight: the weight that the newest samples deserve in a tile, from how surely its light has changed.
// Source:  ours. Over a window the mean difference d between samples and history has the variance v of a mean of
//          independent differences; d^2 / v, here called significance, is 1 on average where nothing changed (less
//          where sums of earlier frames are kept, which count as if they were of this one). What exceeds the threshold
//          is taken for the squared bias b^2 of the history, in the same units. The mean squared error of a blend,
//          (1 - w)^2 b^2 + w^2 c, is least at w = b^2 / (b^2 + c); c, the noise that one frame has left after the
//          filter, is the setting changeGain.
//          Luminance and chrominance are tested alike, and the more significant counts: a cold light that goes out while
//          a warm one goes on may leave a place as bright as it was.
//          Light that changes goes on changing, and not in one tile alone: the mean significance around a tile over the
//          last frames, its recent change, tells how likely change is there. Where light has been still it takes much to
//          believe in change, so noise shortens few histories; where it has not, little.
//          What is smaller than a window, or goes up and down within one, cancels out in its mean. It shows in a tile whose
//          differences agree from pixel to pixel (change_sums): the odds of that count as a significance.
// In:      sums of change_sums, recent change of the frame before (1 float per tile and signal).
// Out:     recent change; weight (1 float per tile and signal), [0, mostWeight]. The largest of the significances of two
//          windows and of the tile counts.
// Border:  tiles outside the image are left out; for recent change they count as the nearest tile.
// Grid:    one work-item a tile.
// Scale:   differences of any brightness give the same weight.
#include "change_weight_ports.h"
#include "common/lanes.h"

// A weighted mean over the tiles around a tile: the weights of a tent, the pixels in each tile.
typedef struct WindowSums {
  float8 weighted;      // records of change_sums
  float weightSquares;  // of all pixels
  float fullWeight;     // as if all pixels of all tiles had been compared
} WindowSums;

QUELL_INLINE WindowSums sumWindow(__global const float* sums, ChangeParams params, int tileX, int tileY,
                                  int radius) {
  WindowSums window = {(float8)(0.0f), 0.0f, 0.0f};
  for (int dy = -radius; dy <= radius; ++dy) {
    const int row = tileY + dy;
    if (row < 0 || row >= params.tilesY) continue;
    for (int dx = -radius; dx <= radius; ++dx) {
      const int column = tileX + dx;
      if (column < 0 || column >= params.tilesX) continue;
      const float tent = (float)((radius + 1 - abs(dx)) * (radius + 1 - abs(dy)));
      const float8 tile = vload8(row * params.tilesX + column, sums);
      window.weighted += tent * tile;
      window.weightSquares += tent * tent * tile.s0;
      window.fullWeight += tent * (float)(QUELL_TILE * QUELL_TILE);
    }
  }
  return window;
}

// Of the mean difference over a window, squared, in variances; the larger of luminance and chrominance.
QUELL_INLINE float significanceOf(WindowSums window) {
  const float weight = window.weighted.s0;
  if (weight < QUELL_CHANGE_LEAST_SHARE * window.fullWeight) return 0.0f;
  // As QUELL_CHANGE_SUM and QUELL_CHANGE_SQUARES have them: x luminance, y chrominance.
  const float2 mean = window.weighted.s13 / weight;
  const float2 spread = window.weighted.s24 / weight - mean * mean;
  const float luminanceSpread = max(spread.x, QUELL_CHANGE_LEAST_SPREAD);
  const float leastChrominance =
      max(QUELL_CHANGE_LEAST_CHROMINANCE * luminanceSpread, QUELL_CHANGE_LEAST_SPREAD);
  const float chrominanceSpread = max(spread.y, leastChrominance);
  const float2 bySpread = mean * mean / (float2)(luminanceSpread, chrominanceSpread);
  return max(bySpread.x, bySpread.y) * (weight * weight / window.weightSquares);
}

// Recent change of the frame before, over a tent of 3x3 tiles: it spreads by a tile a frame, as light that moves does.
QUELL_INLINE float recentChangeAround(__global const float* recentChange, ChangeParams params, int tileX,
                                      int tileY) {
  float sum = 0.0f;
  for (int dy = -1; dy <= 1; ++dy) {
    const int row = clamp(tileY + dy, 0, params.tilesY - 1);
    for (int dx = -1; dx <= 1; ++dx) {
      const int column = clamp(tileX + dx, 0, params.tilesX - 1);
      sum += (float)((2 - abs(dx)) * (2 - abs(dy))) * recentChange[row * params.tilesX + column];
    }
  }
  return sum * 0.0625f;  // a tent of 3x3 sums to 16
}

QUELL_INLINE float weightOf(float significance, float recentChange, ChangeParams params) {
  const float changing = clamp((recentChange - QUELL_RECENT_CHANGE_NONE) *
                                   (1.0f / (QUELL_RECENT_CHANGE_SURE - QUELL_RECENT_CHANGE_NONE)),
                               0.0f, 1.0f);
  const float threshold =
      params.thresholdSquared + changing * (params.recentChangeThresholdSquared - params.thresholdSquared);
  const float excess = max(significance - threshold, 0.0f);
  // A difference of the largest irradiance over a spread of nothing is still finite: (65504 / 0.01)^2 / 1e-20 times the
  // pixels of a window.
  return params.mostWeight * (excess / (excess + params.gain));
}

__kernel void change_weight(STAGE_ARGUMENTS(CHANGE_WEIGHT) ChangeParams params) {
  const int tileX = (int)get_global_id(0);
  const int tileY = (int)get_global_id(1);
  if (tileX >= params.tilesX || tileY >= params.tilesY) return;
  const int tiles = params.tilesX * params.tilesY;
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    __global const float* signalSums = changeSums + s * tiles * QUELL_CHANGE_RECORD;
    const float overWindows =
        max(significanceOf(sumWindow(signalSums, params, tileX, tileY, QUELL_CHANGE_SMALL_WINDOW)),
            significanceOf(sumWindow(signalSums, params, tileX, tileY, QUELL_CHANGE_LARGE_WINDOW)));
    const int record = (tileY * params.tilesX + tileX) * QUELL_CHANGE_RECORD;
    const float significance = max(overWindows, signalSums[record + QUELL_CHANGE_AGREEMENT]);
    const float newest = min(significance, QUELL_RECENT_CHANGE_MOST);
    const float before =
        params.restarted ? newest : recentChangeAround(recentChangePrev + s * tiles, params, tileX, tileY);
    const float now = newest + QUELL_RECENT_CHANGE_KEPT * (before - newest);
    const int tile = s * tiles + tileY * params.tilesX + tileX;
    recentChange[tile] = now;
    changeWeights[tile] = weightOf(significance, now, params);
  }
}

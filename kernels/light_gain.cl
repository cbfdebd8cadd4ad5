// light_gain: what filtered irradiance is to be multiplied by, around each tile, to have the light of its history again.
// Source:  ours. Edge stops compare noisy luminance: a bright pixel finds no equals and stays with itself, its neighbours
//          leave it out, and what they become is darker than the mean of what came in, the more so the longer the tail of
//          the noise. The history has the right light: what a window's mean lacks of it is given back.
//          A pixel of luminance l gets the ratio 1 + gain * l. So what was lost is given back by the squares of luminance:
//          noise is strong in what is bright, and dark pixels next to that have lost nothing.
//          The loss may be one tile's firefly, which must not brighten the rest. With e the light lost in a tile and k its
//          weight, (sum of k e)^2 is on average the square of what is lost everywhere, plus the sum of (k e)^2 for what
//          tiles differ by independently. The gain is as large as the first is part of both: 0 where one tile lost it all.
// In:      sums of light_sums.
// Out:     gain (1 float per tile and signal), 1 / luminance of irradiance, of either sign; 0 where there is no light.
// Border:  tiles outside the image are left out.
// Grid:    one work-item a tile.
// Scale:   light of any brightness gives pixels the same ratio.
#include "common/lanes.h"
#include "light_gain_ports.h"

// Sums over a window, each of a record's numbers by itself.
typedef struct WeightedSums {
  float8 weighted;  // of four tiles of a row
  float8 squares;   // of what is weighted
} WeightedSums;

// Weights of four tiles of a row from `column` on, once for each number of a record.
QUELL_INLINE float8 tentWeights(int column, int tileX, int tilesX) {
  const int8 columns = column + (int8)(0, 0, 1, 1, 2, 2, 3, 3);
  const float8 tent = convert_float8(QUELL_LIGHT_WINDOW + 1 - convert_int8(abs(columns - tileX)));
  return columns < tilesX && tent > 0.0f ? tent : (float8)(0.0f);
}

// Adds four tiles; what lies beyond the row counts for nothing.
QUELL_INLINE WeightedSums addTiles(WeightedSums window, __global const float* records, float8 tent) {
  const float8 weighted = tent > 0.0f ? tent * vload8(0, records) : (float8)(0.0f);
  window.weighted += weighted;
  window.squares += weighted * weighted;
  return window;
}

// Of every other number, from the first or second on.
QUELL_INLINE float totalOf(float4 v) { return (v.x + v.y) + (v.z + v.w); }

QUELL_INLINE float gainAround(__global const float* sums, LightParams params, int tileX, int tileY) {
  // These columns hold every window; the last ones of a row those at the border.
  const int first = max(min(tileX - QUELL_LIGHT_WINDOW, params.tilesX - QUELL_LIGHT_COLUMNS), 0);
  const float8 left = tentWeights(first, tileX, params.tilesX);
  const float8 middle = tentWeights(first + 4, tileX, params.tilesX);
  const float8 right = tentWeights(first + 8, tileX, params.tilesX);
  const int lastRow = min(tileY + QUELL_LIGHT_WINDOW, params.tilesY - 1);
  WeightedSums window = {(float8)(0.0f), (float8)(0.0f)};
  for (int row = max(tileY - QUELL_LIGHT_WINDOW, 0); row <= lastRow; ++row) {
    const float tent = (float)(QUELL_LIGHT_WINDOW + 1 - abs(row - tileY));
    __global const float* records = sums + (row * params.tilesX + first) * QUELL_LIGHT_RECORD;
    window = addTiles(window, records, tent * left);
    window = addTiles(window, records + 8, tent * middle);
    window = addTiles(window, records + 16, tent * right);
  }
  const float lost = totalOf(window.weighted.even);
  const float squares = totalOf(window.weighted.odd);
  const float lostSquares = totalOf(window.squares.even);
  const float lostSquared = lost * lost;
  if (!(lostSquares < lostSquared && squares > 0.0f)) return 0.0f;
  const float sure = 1.0f - lostSquares / lostSquared;
  return clamp(sure * (lost / squares), -QUELL_LIGHT_MOST_GAIN, QUELL_LIGHT_MOST_GAIN);
}

__kernel void light_gain(STAGE_ARGUMENTS(LIGHT_GAIN) LightParams params) {
  const int tileX = (int)get_global_id(0);
  const int tileY = (int)get_global_id(1);
  if (tileX >= params.tilesX || tileY >= params.tilesY) return;
  const int tiles = params.tilesX * params.tilesY;
  for (int s = 0; s < QUELL_SIGNALS; ++s)
    lightGain[s * tiles + tileY * params.tilesX + tileX] =
        gainAround(lightSums + s * tiles * QUELL_LIGHT_RECORD, params, tileX, tileY);
}

// Sums over the rows of tiles, and values of tiles, interpolated bilinearly between their centres; constant beyond the outermost
// ones.
#ifndef QUELL_COMMON_TILES_H
#define QUELL_COMMON_TILES_H

#include "common/lanes.h"
#include "common/tiles_params.h"

// Of one number for each of a row's pixels.
QUELL_INLINE float total(float8 v) {
  const float4 pairs = v.lo + v.hi;
  return (pairs.x + pairs.y) + (pairs.z + pairs.w);
}

// Where pixels lie between the centres of tiles.
typedef struct TileMix {
  int top;         // element of the upper row of tiles
  int bottom;      // and of the lower
  int left;        // column of tiles whose centre is left of the first pixel, -1 at the border
  int lastColumn;  // of the grid
  floatL fractionX;
  float fractionY;
} TileMix;

// Of the pixels from (x, y) on, x a multiple of QUELL_LANES.
QUELL_INLINE TileMix mixTiles(int tilesX, int tilesY, int x, int y) {
  const floatL u = (TO_FLOAT(x + LANE_INDEX) + 0.5f) * (1.0f / QUELL_TILE) - 0.5f;
  const float v = ((float)y + 0.5f) * (1.0f / QUELL_TILE) - 0.5f;
  const int row = (int)floor(v);
  TileMix mix;
  mix.top = max(row, 0) * tilesX;
  mix.bottom = min(row + 1, tilesY - 1) * tilesX;
  mix.left = (x + QUELL_TILE / 2) / QUELL_TILE - 1;
  mix.lastColumn = tilesX - 1;
  mix.fractionX = u - TO_FLOAT(floorLanes(u));
  mix.fractionY = v - (float)row;
  return mix;
}

// Of one column of tiles, between its two rows.
QUELL_INLINE float mixRows(__global const float* values, TileMix mix, int column) {
  const int inside = clamp(column, 0, mix.lastColumn);
  return values[mix.top + inside] * (1.0f - mix.fractionY) + values[mix.bottom + inside] * mix.fractionY;
}

QUELL_INLINE floatL mixedValue(__global const float* values, TileMix mix) {
  const float a = mixRows(values, mix, mix.left);
  const float b = mixRows(values, mix, mix.left + 1);
  // The centres of tiles are half a tile from their edges: pixels up to there are mixed alike.
#if QUELL_LANES <= QUELL_TILE / 2
  const floatL left = (floatL)(a);
  const floatL right = (floatL)(b);
#elif QUELL_LANES == QUELL_TILE
  const float c = mixRows(values, mix, mix.left + 2);
  const floatL left = (floatL)((float4)(a), (float4)(b));
  const floatL right = (floatL)((float4)(b), (float4)(c));
#else
  const float c = mixRows(values, mix, mix.left + 2);
  const float d = mixRows(values, mix, mix.left + 3);
  const floatL left = (floatL)((float4)(a), (float8)(b), (float4)(c));
  const floatL right = (floatL)((float4)(b), (float8)(c), (float4)(d));
#endif
  return left + mix.fractionX * (right - left);
}

#endif

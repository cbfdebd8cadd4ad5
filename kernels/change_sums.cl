// change_sums: per tile of 8x8 pixels, how far the newest samples lie from the history that they were blended into.
// Source:  ours. Fast against slow history, over tiles, is how others notice changed light without rays of its own
//          (Zhdan 2021, ReBLUR and ReLAX); here the noise of the difference is measured along with it.
// In:      innovation (2 planes per signal, see common/innovation.h), history length (bytes per signal; 1 or less: no
//          history), sums of the frame before.
// Out:     per signal and tile: pixels with a history (a missing sample counts with a difference of 0), sum and sum of
//          squares of their differences, plus the share sumsKept of the sums of the frame before. Tiles do not move
//          with the camera: a tile is wide against one frame's motion, and what is kept fades. And, of this frame alone,
//          the odds that the luminance of neighbours differs alike: noise differs from pixel to pixel, in the sample as in
//          the history; screens, hard shadows and glints that change do not.
// Border:  pixels outside the image are left out.
// Grid:    one work-item a tile.
#include "change_sums_ports.h"
#include "common/planes.h"
#include "common/tiles.h"

typedef struct TileSums {
  float8 count;
  float8 sum[QUELL_INNOVATION_PLANES];
  float8 squares[QUELL_INNOVATION_PLANES];
} TileSums;

// Of pairs of neighbours: the squares of their differences from history, and the part of them that agrees.
typedef struct PairSums {
  float8 squares;
  float8 agreed;
} PairSums;

// A row's differences of luminance and which of its pixels were compared.
typedef struct TileRow {
  float8 luminance;
  int8 compared;
} TileRow;

QUELL_INLINE TileSums emptySums(void) {
  TileSums sums;
  sums.count = (float8)(0.0f);
  for (int i = 0; i < QUELL_INNOVATION_PLANES; ++i) {
    sums.sum[i] = (float8)(0.0f);
    sums.squares[i] = (float8)(0.0f);
  }
  return sums;
}

// Which of the eight pixels from an element on have a history to be compared with.
QUELL_INLINE int8 comparedPixels(__global const uchar* historyLength, int8 inside) {
  return inside && convert_int8(vload8(0, historyLength)) > 1;
}

QUELL_INLINE TileSums addRow(TileSums sums, __global const float* innovation, int stride, int8 compared) {
  sums.count += compared ? (float8)(1.0f) : (float8)(0.0f);
  for (int i = 0; i < QUELL_INNOVATION_PLANES; ++i) {
    const float8 difference = compared ? vload8(0, innovation + i * stride) : (float8)(0.0f);
    sums.sum[i] += difference;
    sums.squares[i] += difference * difference;
  }
  return sums;
}

QUELL_INLINE PairSums addPairs(PairSums sums, TileRow a, TileRow b) {
  const float8 squares = a.luminance * a.luminance + b.luminance * b.luminance;
  const float8 apart = (a.luminance - b.luminance) * (1.0f / QUELL_CHANGE_AGREED_SHARE);
  const float8 agreed = squares * (squares / (squares + apart * apart + QUELL_CHANGE_LEAST_SPREAD));
  const int8 both = a.compared && b.compared;
  sums.squares += both ? squares : (float8)(0.0f);
  sums.agreed += both ? agreed : (float8)(0.0f);
  return sums;
}

// The row moved by one pixel, for its pairs of neighbours.
QUELL_INLINE TileRow nextPixels(TileRow row) {
  TileRow next;
  next.luminance = row.luminance.s12345677;
  next.compared = row.compared.s12345677 && (int8)(-1, -1, -1, -1, -1, -1, -1, 0);
  return next;
}

QUELL_INLINE float oddsOf(PairSums pairs) {
  const float chance = total(pairs.agreed) / max(total(pairs.squares), QUELL_CHANGE_LEAST_SPREAD);
  return chance / max(1.0f - chance, QUELL_CHANGE_LEAST_DOUBT);
}

QUELL_INLINE TileRow tileRow(__global const float* luminance, __global const uchar* historyLength,
                             int8 inside) {
  TileRow row;
  row.luminance = vload8(0, luminance);
  row.compared = comparedPixels(historyLength, inside);
  return row;
}

// Odds that neighbours among the tile's luminances agree, in the direction in which more do: along an edge, not across.
// One walk over the tile a direction: sixteen divisions at once take more registers than two waves have.
QUELL_INLINE float agreementOf(__global const float* luminance, __global const uchar* historyLength,
                               int pitch, int rows, int8 inside) {
  PairSums beside = {(float8)(0.0f), (float8)(0.0f)};
  PairSums below = beside;
#pragma unroll 1
  for (int row = 0; row < rows; ++row) {
    const TileRow here = tileRow(luminance + row * pitch, historyLength + row * pitch, inside);
    beside = addPairs(beside, here, nextPixels(here));
  }
  TileRow above = tileRow(luminance, historyLength, inside);
#pragma unroll 1
  for (int row = 1; row < rows; ++row) {
    const TileRow here = tileRow(luminance + row * pitch, historyLength + row * pitch, inside);
    below = addPairs(below, above, here);
    above = here;
  }
  return max(oddsOf(beside), oddsOf(below));
}

__kernel void change_sums(STAGE_ARGUMENTS(CHANGE_SUMS) ChangeParams params) {
  const PlaneParams planes = params.planes;
  const int tileX = (int)get_global_id(0);
  const int tileY = (int)get_global_id(1);
  if (tileX >= params.tilesX || tileY >= params.tilesY) return;
  const int x = tileX * QUELL_TILE;
  const int y = tileY * QUELL_TILE;
  const int8 inside = x + (int8)(0, 1, 2, 3, 4, 5, 6, 7) < planes.width;
  const int first = planeIndex(planes, x, y);
  const int rows = min(QUELL_TILE, planes.height - y);
  const int tiles = params.tilesX * params.tilesY;
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    TileSums tile = emptySums();
    __global const float* tileInnovation = innovation + QUELL_INNOVATION_PLANES * s * planes.stride + first;
    __global const uchar* tileLength = historyLength + s * planes.stride + first;
    for (int row = 0; row < rows; ++row) {
      tile = addRow(tile, tileInnovation + row * planes.pitch, planes.stride,
                    comparedPixels(tileLength + row * planes.pitch, inside));
    }
    const float leastPixels = QUELL_CHANGE_AGREED_PIXELS * (float)(QUELL_TILE * QUELL_TILE);
    const float agreement = agreementOf(tileInnovation + QUELL_INNOVATION_LUMINANCE * planes.stride,
                                        tileLength, planes.pitch, rows, inside);
    const int record = s * tiles + tileY * params.tilesX + tileX;
    const float8 newest = (float8)(total(tile.count), total(tile.sum[QUELL_INNOVATION_LUMINANCE]),
                                   total(tile.squares[QUELL_INNOVATION_LUMINANCE]),
                                   total(tile.sum[QUELL_INNOVATION_CHROMINANCE]),
                                   total(tile.squares[QUELL_INNOVATION_CHROMINANCE]), 0.0f, 0.0f, 0.0f);
    float8 sums = newest + params.sumsKept * vload8(record, changeSumsPrev);
    sums.s5 = total(tile.count) < leastPixels ? 0.0f : agreement;  // QUELL_CHANGE_AGREEMENT
    vstore8(sums, record, changeSums);
  }
}

// change_sums: per tile of 8x8 pixels, how far the newest samples lie from the history that they were blended into.
// Source:  ours. Fast against slow history, over tiles, is how others notice changed light without rays of its own
//          (Zhdan 2021, ReBLUR and ReLAX); here the noise of the difference is measured along with it.
// In:      innovation (2 planes per signal, see common/innovation.h), history length (bytes per signal; 1 or less: no
//          history), sums of the frame before.
// Out:     per signal and tile: pixels with a history (a missing sample counts with a difference of 0), sum and sum of
//          squares of their differences, plus the share sumsKept of the sums of the frame before. Tiles do not move
//          with the camera: a tile is wide against one frame's motion, and what is kept fades.
// Border:  pixels outside the image are left out.
// Grid:    one work-item a tile.
#include "change_sums_ports.h"
#include "common/planes.h"

typedef struct TileSums {
  float8 count;
  float8 sum[QUELL_INNOVATION_PLANES];
  float8 squares[QUELL_INNOVATION_PLANES];
} TileSums;

QUELL_INLINE TileSums emptySums(void) {
  TileSums sums;
  sums.count = (float8)(0.0f);
  for (int i = 0; i < QUELL_INNOVATION_PLANES; ++i) {
    sums.sum[i] = (float8)(0.0f);
    sums.squares[i] = (float8)(0.0f);
  }
  return sums;
}

QUELL_INLINE TileSums addRow(TileSums sums, __global const float* innovation,
                             __global const uchar* historyLength, int stride, int8 inside) {
  const int8 compared = inside && convert_int8(vload8(0, historyLength)) > 1;
  sums.count += compared ? (float8)(1.0f) : (float8)(0.0f);
  for (int i = 0; i < QUELL_INNOVATION_PLANES; ++i) {
    const float8 difference = compared ? vload8(0, innovation + i * stride) : (float8)(0.0f);
    sums.sum[i] += difference;
    sums.squares[i] += difference * difference;
  }
  return sums;
}

QUELL_INLINE float total(float8 v) {
  const float4 pairs = v.lo + v.hi;
  return (pairs.x + pairs.y) + (pairs.z + pairs.w);
}

__kernel void change_sums(STAGE_ARGUMENTS(CHANGE_SUMS) ChangeParams params) {
  const PlaneParams planes = params.planes;
  const int tileX = (int)get_global_id(0);
  const int tileY = (int)get_global_id(1);
  if (tileX >= params.tilesX || tileY >= params.tilesY) return;
  const int x = tileX * QUELL_TILE;
  const int y = tileY * QUELL_TILE;
  const int8 inside = x + (int8)(0, 1, 2, 3, 4, 5, 6, 7) < planes.width;
  const int tiles = params.tilesX * params.tilesY;
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    TileSums tile = emptySums();
    for (int row = 0; row < QUELL_TILE; ++row) {
      if (y + row >= planes.height) break;
      const int index = planeIndex(planes, x, y + row);
      tile = addRow(tile, innovation + QUELL_INNOVATION_PLANES * s * planes.stride + index,
                    historyLength + s * planes.stride + index, planes.stride, inside);
    }
    const int record = s * tiles + tileY * params.tilesX + tileX;
    const float8 newest = (float8)(total(tile.count), total(tile.sum[QUELL_INNOVATION_LUMINANCE]),
                                   total(tile.squares[QUELL_INNOVATION_LUMINANCE]),
                                   total(tile.sum[QUELL_INNOVATION_CHROMINANCE]),
                                   total(tile.squares[QUELL_INNOVATION_CHROMINANCE]), 0.0f, 0.0f, 0.0f);
    vstore8(newest + params.sumsKept * vload8(record, changeSumsPrev), record, changeSums);
  }
}

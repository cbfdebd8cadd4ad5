// blended_sum: evaluates the fits of overlapping windows with the noise-free features, blended between tile centres.
// Paper:   Koskela et al. 2019, eq. (6) and its limitation 3 (block edges): the predictions of the four nearest
//          windows are interpolated bilinearly, so that there is no edge to see, even without history.
// In:      records of gram_solve (one a tile), guides of this frame (see common/guides.h); materials (4 planes) where
//          a feature needs them. Out: fitted irradiance (3 planes per signal, of which those of QUELL_SIGNAL are
//          written), >= 0; 0 at background.
// Grid:    work-items follow the cells between tile centres, in which all pixels see the same four windows: one
//          work-item takes QUELL_LANES pixels of a cell (with sixteen lanes and tiles of 8: two rows of eight).
#include "blended_sum_ports.h"
#include "common/fit_features.h"
#include "common/planes.h"
#include "common/surfaces.h"

#define ITEM_WIDTH (QUELL_LANES < GRAM_TILE_EDGE ? QUELL_LANES : GRAM_TILE_EDGE)
#define ITEM_HEIGHT (QUELL_LANES / ITEM_WIDTH)
#define ITEMS_PER_CELL_ROW (GRAM_TILE_EDGE / ITEM_WIDTH)

#if QUELL_LANES == 16 && GRAM_TILE_EDGE == 8
#define LANE_X ((int16)(0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7))
#define LANE_Y ((int16)(0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1))
QUELL_INLINE floatL loadItem(__global const float* plane, int pitch) {
  return (float16)(vload8(0, plane), vload8(0, plane + pitch));
}
QUELL_INLINE void storeItem(floatL value, __global float* plane, int pitch) {
  vstore8(value.lo, 0, plane);
  vstore8(value.hi, 0, plane + pitch);
}
#else
#define LANE_X LANE_INDEX
#define LANE_Y ((intL)(0))
QUELL_INLINE floatL loadItem(__global const float* plane, int pitch) { return loadLanes(plane); }
QUELL_INLINE void storeItem(floatL value, __global float* plane, int pitch) { storeLanes(value, plane); }
#endif

QUELL_INLINE float3L loadItem3(__global const float* planes, int pitch, int stride) {
  float3L v;
  v.x = loadItem(planes, pitch);
  v.y = loadItem(planes + stride, pitch);
  v.z = loadItem(planes + 2 * stride, pitch);
  return v;
}

// First and last tile of an axis whose windows are used. A window whose centre lies outside the image has seen little
// of what it would be asked about, so the nearest one inside stands in for it.
QUELL_INLINE int2 usedTiles(int offset, int size) {
  int first = 0;
  int last = (size - 1 - offset) / GRAM_TILE_EDGE;
  if (last > first && offset + GRAM_TILE_EDGE / 2 < 0) ++first;
  if (last > first && offset + last * GRAM_TILE_EDGE + GRAM_TILE_EDGE / 2 >= size) --last;
  return (int2)(first, last);
}

__kernel void blended_sum(STAGE_ARGUMENTS(BLENDED_SUM) GramParams params) {
  const int itemX = (int)get_global_id(0);
  const int itemY = (int)get_global_id(1);
  // Cells lie between tile centres, so the first one starts half a tile before the image.
  const int cellX = itemX / ITEMS_PER_CELL_ROW;
  const int cellY = itemY / (GRAM_TILE_EDGE / ITEM_HEIGHT);
  const int x = params.tileOffsetX - GRAM_TILE_EDGE / 2 + itemX * ITEM_WIDTH;
  const int y = params.tileOffsetY - GRAM_TILE_EDGE / 2 + itemY * ITEM_HEIGHT;
  if (cellX > params.tilesX || cellY > params.tilesY || x <= -ITEM_WIDTH || x >= params.planes.width ||
      y <= -ITEM_HEIGHT || y >= params.planes.height)
    return;
  if (SKIP && !anySurface(surfaces, params.planes, x, y, x + ITEM_WIDTH - 1, y + ITEM_HEIGHT - 1)) return;
  const int index = planeIndex(params.planes, x, y);
  const int pitch = params.planes.pitch;
  const int stride = params.planes.stride;
  Guide guide;
  guide.position = loadItem3(guides + QUELL_GUIDE_POSITION * stride + index, pitch, stride);
  guide.normal = loadItem3(guides + QUELL_GUIDE_NORMAL * stride + index, pitch, stride);
#if QUELL_USES_PIXEL
  guide.column = TO_FLOAT(x + LANE_X);
  guide.row = TO_FLOAT(y + LANE_Y);
#endif
#if QUELL_USES_MATERIAL
  guide.albedo = loadItem3(materials + QUELL_MATERIAL_ALBEDO * stride + index, pitch, stride);
  guide.roughness = loadItem(materials + QUELL_MATERIAL_ROUGHNESS * stride + index, pitch);
#endif

  const int2 columns = usedTiles(params.tileOffsetX, params.planes.width);
  const int2 rows = usedTiles(params.tileOffsetY, params.planes.height);
  const int left = clamp(cellX - 1, columns.x, columns.y);
  const int right = clamp(cellX, columns.x, columns.y);
  const int top = clamp(cellY - 1, rows.x, rows.y) * params.tilesX;
  const int bottom = clamp(cellY, rows.x, rows.y) * params.tilesX;
  const floatL fractionX =
      (TO_FLOAT((itemX % ITEMS_PER_CELL_ROW) * ITEM_WIDTH + LANE_X) + 0.5f) * (1.0f / GRAM_TILE_EDGE);
  const floatL fractionY =
      (TO_FLOAT((itemY % (GRAM_TILE_EDGE / ITEM_HEIGHT)) * ITEM_HEIGHT + LANE_Y) + 0.5f) *
      (1.0f / GRAM_TILE_EDGE);

  float3L sum = splat3(0.0f);
  floatL total = ZERO_LANES;
  for (int corner = 0; corner < 4; ++corner) {
    const int tile = (corner & 2 ? bottom : top) + (corner & 1 ? right : left);
    __global const float* record = fitRecords + tile * QUELL_FIT_RECORD;
    // A window without a single sample has nothing to say.
    if (record[QUELL_FIT_USABLE] != 0.0f) {
      const floatL share =
          (corner & 1 ? fractionX : 1.0f - fractionX) * (corner & 2 ? fractionY : 1.0f - fractionY);
      sum = add3(sum, scale3(evaluateFit(record, guide, params.viewAxis), share));
      total += share;
    }
  }
  sum = scale3(sum, 1.0f / (total > 0.0f ? total : ONE_LANES));
  const intL surface = dot3(guide.normal, guide.normal) > 0.0f && isFinite3(sum);
  const float3L result = select3(surface, clamp3(sum, 0.0f, QUELL_MAX_RADIANCE), splat3(0.0f));
  __global float* target = fitted + 3 * QUELL_SIGNAL * stride + index;
  storeItem(result.x, target, pitch);
  storeItem(result.y, target + stride, pitch);
  storeItem(result.z, target + 2 * stride, pitch);
}

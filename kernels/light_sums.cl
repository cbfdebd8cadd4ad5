// light_sums: per tile of 8x8 pixels, how much light the filter lost.
// Source:  ours; see light_gain.
// In:      luminance of the history (1 plane per signal, its mean over 3x3 pixels, see variance.cl), filtered irradiance
//          (3 planes per signal), guides (the weights alone).
// Out:     per signal and tile, over every second row, weighted sums: of the luminance of the history less that of the
//          filtered irradiance, at most QUELL_LIGHT_MOST_LOST times the latter; and of the square of the latter.
// Border:  pixels outside the image and those without a sample are left out.
// Grid:    one work-item a tile.
#include "common/guides.h"
#include "common/luminance.h"
#include "common/planes.h"
#include "common/tiles.h"
#include "light_sums_ports.h"

typedef struct LightSums {
  float8 lost;
  float8 left;  // luminance of the filtered irradiance
  float8 squares;
} LightSums;

// The pointers are those of the signal's planes, moved to the row.
QUELL_INLINE LightSums addLight(LightSums sums, __global const float* history, __global const float* filtered,
                                __global const float* weights, int stride, int8 inside) {
  const float8 weight = vload8(0, weights);
  const int8 counts = inside && weight > 0.0f;
  const float8 luminance =
      LUMINANCE_OF(vload8(0, filtered), vload8(0, filtered + stride), vload8(0, filtered + 2 * stride));
  sums.lost += counts ? weight * (vload8(0, history) - luminance) : (float8)(0.0f);
  sums.left += counts ? weight * luminance : (float8)(0.0f);
  sums.squares += counts ? weight * luminance * luminance : (float8)(0.0f);
  return sums;
}

__kernel void light_sums(STAGE_ARGUMENTS(LIGHT_SUMS) LightParams params) {
  const PlaneParams planes = params.planes;
  const int stride = planes.stride;
  const int tileX = (int)get_global_id(0);
  const int tileY = (int)get_global_id(1);
  if (tileX >= params.tilesX || tileY >= params.tilesY) return;
  const int x = tileX * QUELL_TILE;
  const int y = tileY * QUELL_TILE;
  const int8 inside = x + (int8)(0, 1, 2, 3, 4, 5, 6, 7) < planes.width;
  const int tiles = params.tilesX * params.tilesY;
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    LightSums sums = {(float8)(0.0f), (float8)(0.0f), (float8)(0.0f)};
    for (int row = 0; row < QUELL_TILE; row += QUELL_LIGHT_ROW_STEP) {
      if (y + row >= planes.height) break;
      const int index = planeIndex(planes, x, y + row);
      sums = addLight(sums, stopLuminance + s * stride + index, filtered + 3 * s * stride + index,
                      guides + (QUELL_GUIDE_WEIGHT + s) * stride + index, stride, inside);
    }
    const int record = s * tiles + tileY * params.tilesX + tileX;
    const float lost = min(total(sums.lost), QUELL_LIGHT_MOST_LOST * total(sums.left));
    vstore2((float2)(lost, total(sums.squares)), record, lightSums);
  }
}

// classify: how many iterations of the filter each tile of 16x8 pixels needs.
// Source:  ours. The variance of the accumulated irradiance, averaged over the tile, shrinks with every iteration by a
//          known factor; the filter may stop once the rest, display-encoded around the tile's mean luminance, is below
//          the tolerance. Edges let less noise go than that, so the tolerance is small.
// In:      variance (1 plane per signal), moments of luminance (2 planes per signal).
// Out:     level (1 byte a tile), 1 to `iterations`; `iterations` where nothing is known.
// Rows:    every second one is looked at: half the reading, and neighbours are alike.
// Border:  pixels outside the image are left out.
// Grid:    one work-item a tile; neighbours read neighbouring memory.
#include "classify_params.h"
#include "common/guides.h"
#include "common/planes.h"
#include "common/tiles.h"

#define LANES_OF_TILE ((int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15))

QUELL_INLINE float total(float16 v) {
  const float8 a = v.lo + v.hi;
  const float4 b = a.lo + a.hi;
  return (b.x + b.y) + (b.z + b.w);
}

// Iterations after which noise of this deviation around this luminance cannot be seen any more. A square root stands in
// for the display's gamma.
QUELL_INLINE int iterationsFor(float deviation, float luminance, ClassifyParams params) {
  const float level = min(luminance, 1.0f);
  const float encoded = sqrt(level);
  float noise = deviation * QUELL_FIRST_ITERATION_NOISE;
  int iterations = 1;
  while (iterations < params.iterations && sqrt(level + noise) - encoded > params.tolerance) {
    noise *= QUELL_LATER_ITERATION_NOISE;
    ++iterations;
  }
  return iterations;
}

// Mean variance (.x) and mean luminance (.y) of a tile, and its pixels that have any (.z).
QUELL_INLINE float3 tileMeans(__global const float* variance, __global const float* luminance,
                              PlaneParams planes, int x, int y) {
  float16 variances = (float16)(0.0f);
  float16 luminances = (float16)(0.0f);
  float16 count = (float16)(0.0f);
  const int16 inside = x + LANES_OF_TILE < planes.width;
  for (int row = 0; row < QUELL_TILE_HEIGHT; row += 2) {
    if (y + row >= planes.height) break;
    const int index = planeIndex(planes, x, y + row);
    const float16 v = vload16(0, variance + index);
    const float16 l = vload16(0, luminance + index);
    const int16 lit = inside && (v > 0.0f || l > 0.0f);
    variances += lit ? v : (float16)(0.0f);
    luminances += lit ? l : (float16)(0.0f);
    count += lit ? (float16)(1.0f) : (float16)(0.0f);
  }
  const float pixels = total(count);
  const float inverse = 1.0f / max(pixels, 1.0f);
  return (float3)(total(variances) * inverse, total(luminances) * inverse, pixels);
}

// A tile without any light has levels of its background, which nobody reads, or surfaces in rows not looked at.
__kernel void classify(__global const float* variance, __global const float* moments, __global uchar* levels,
                       ClassifyParams params) {
  const PlaneParams planes = params.planes;
  const int tileX = (int)get_global_id(0);
  const int tileY = (int)get_global_id(1);
  if (tileX >= params.tilesX || tileY >= params.tilesY) return;
  int level = 1;
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const float3 means = tileMeans(variance + s * planes.stride,
                                   moments + (QUELL_MOMENT_PLANES * s + QUELL_MOMENT_FIRST) * planes.stride,
                                   planes, tileX * QUELL_TILE_WIDTH, tileY * QUELL_TILE_HEIGHT);
    const int needed = means.z > 0.0f ? iterationsFor(sqrt(means.x), means.y, params) : params.iterations;
    level = max(level, needed);
  }
  levels[tileY * params.tilesX + tileX] = (uchar)level;
}

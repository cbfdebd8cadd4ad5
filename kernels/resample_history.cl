// resample_history: the planes of a history at another size, where a frame's render size is not that of the frame before.
// Source:  ours. Each pixel takes all of the pixel whose centre is nearest, so that position, normal, light and length of a
//          history stay together; bilinear weights would mix those of two surfaces.
// In:      planes of ELEMENT at the old size.
// Out:     the same at the new size; margins keep what they held.
#include "common/planes.h"
#include "resample_history_params.h"

// In unsigned numbers: sizes reach 2^15, so the product reaches 2^31.
QUELL_INLINE int nearestPixel(int pixel, int sourceCount, int targetCount) {
  return (int)((uint)(2 * pixel + 1) * (uint)sourceCount / (uint)(2 * targetCount));
}

// Simple copies on purpose: QUELL_LANES pixels a work-item only share its overhead.
__kernel void resample_history(__global const ELEMENT* source, __global ELEMENT* target,
                               ResampleHistoryParams params) {
  const int first = (int)get_global_id(0) * QUELL_LANES;
  const int y = (int)get_global_id(1);
  if (y >= params.target.height) return;
  const int sourceY = nearestPixel(y, params.source.height, params.target.height);
  for (int plane = 0; plane < params.planeCount; ++plane) {
    for (int x = first; x < min(first + QUELL_LANES, params.target.width); ++x) {
      const int sourceX = nearestPixel(x, params.source.width, params.target.width);
      target[plane * params.target.stride + planeIndex(params.target, x, y)] =
          source[plane * params.source.stride + planeIndex(params.source, sourceX, sourceY)];
    }
  }
}

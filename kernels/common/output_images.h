// The caller's outputs: what they are as arguments, and how pixels are stored in them. For stages that have both outputs among
// their ports.
#ifndef QUELL_COMMON_OUTPUT_IMAGES_H
#define QUELL_COMMON_OUTPUT_IMAGES_H

#include "common/image_access.h"

#if LINEAR_FORMAT == QUELL_FORMAT_OBJECT
#define LINEAR_ARGUMENT __write_only image2d_t
#define STORE_LINEAR(value, data, view, x, y, lanes) storeTexels((value), (data), (view), (x), (y), (lanes))
#else
#define LINEAR_ARGUMENT __global uchar*
#define STORE_LINEAR(value, data, view, x, y, lanes) STORE_PIXELS(LINEAR, value, data, view, x, y, lanes)
#endif
#if DISPLAY_FORMAT == QUELL_FORMAT_OBJECT
#define DISPLAY_ARGUMENT __write_only image2d_t
#define STORE_DISPLAY(value, data, view, x, y, lanes) storeTexels((value), (data), (view), (x), (y), (lanes))
#else
#define DISPLAY_ARGUMENT __global uchar*
#define STORE_DISPLAY(value, data, view, x, y, lanes) STORE_PIXELS(DISPLAY, value, data, view, x, y, lanes)
#endif

#if LINEAR_FORMAT == QUELL_FORMAT_OBJECT || DISPLAY_FORMAT == QUELL_FORMAT_OBJECT
// storePixels() for an OpenCL image object: rows follow each other by view.rowPitch, 1 or -1, from view.offset on.
QUELL_INLINE void storeTexels(float3L value, __write_only image2d_t image, ImageViewParams view, int x, int y,
                              int lanes) {
  const int row = view.offset + y * view.rowPitch;
#if QUELL_LANES > 1
  float components[3][QUELL_LANES];
  STORE_VECTOR(value.x, components[0]);
  STORE_VECTOR(value.y, components[1]);
  STORE_VECTOR(value.z, components[2]);
  for (int lane = 0; lane < lanes; ++lane)
    write_imagef(image, (int2)(x + lane, row),
                 (float4)(components[0][lane], components[1][lane], components[2][lane], 1.0f));
#else
  write_imagef(image, (int2)(x, row), (float4)(value.x, value.y, value.z, 1.0f));
#endif
}
#endif

#endif

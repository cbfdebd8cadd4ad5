// The caller's images: loads and stores of QUELL_LANES neighbouring pixels in any layout of the buffer contract.
//
// A kernel that touches the image NAME is compiled with NAME_FORMAT (0 absent, 1 float, 2 half, 3 32-bit unsigned, 4 an
// OpenCL image object, outputs only: see import_image.cl), NAME_CHANNELS (1-4) and NAME_STRIDE (components from one pixel to
// the next). The pitch of rows that lie bottom-up is negative. Packed layouts take vector loads;
// anything else, and the end of a row, is read component by component.
#ifndef QUELL_COMMON_IMAGE_ACCESS_H
#define QUELL_COMMON_IMAGE_ACCESS_H

#include "common/lanes.h"
#include "common/packed_pixels.h"
#include "common/types.h"

// The first component of a pixel. A negative pitch wraps around and back.
QUELL_INLINE size_t pixelComponent(ImageViewParams view, int x, int y, int stride) {
  return (size_t)view.offset + (size_t)y * (size_t)view.rowPitch + (size_t)x * (size_t)stride;
}

// One component of `lanes` pixels; the other lanes are 0.
QUELL_INLINE floatL loadStrided(__global const void* data, size_t component, int format, int stride,
                                int lanes) {
#if QUELL_LANES == 1
  return loadComponent(data, component, format);
#else
  float values[QUELL_LANES];
  for (int lane = 0; lane < QUELL_LANES; ++lane)
    values[lane] = lane < lanes ? loadComponent(data, component + (size_t)(lane * stride), format) : 0.0f;
  return LOAD_VECTOR(values);
#endif
}

// Loads `lanes` pixels from column x of row y: three components; one component is spread over all three, a missing
// third is 0. Lanes from `lanes` on are 0.
QUELL_INLINE float3L loadPixels(__global const void* data, ImageViewParams view, int x, int y, int lanes,
                                int format, int channels, int stride) {
  const size_t first = pixelComponent(view, x, y, stride);
#if QUELL_LANES > 1
  if (lanes == QUELL_LANES) {
    if (channels == 2 && stride == 2) return loadPacked2(data, first, format);
    if (channels == 3 && stride == 3) return loadPacked3(data, first, format);
    if (channels == 4 && stride == 4) return loadPacked4(data, first, format);
    if (channels == 1 && stride == 1) {
      float3L grey;
      grey.x = loadComponents(data, first, format);
      grey.y = grey.x;
      grey.z = grey.x;
      return grey;
    }
  }
#endif
  float3L v;
  v.x = loadStrided(data, first, format, stride, lanes);
  v.y = channels >= 2 ? loadStrided(data, first + 1, format, stride, lanes) : v.x;
  v.z = channels >= 3   ? loadStrided(data, first + 2, format, stride, lanes)
        : channels == 1 ? v.x
                        : ZERO_LANES;
  return v;
}

// One pixel a lane, from the columns given, which must lie in the image; components as loadPixels() has them.
QUELL_INLINE float3L gatherPixels(__global const void* data, ImageViewParams view, intL column, int y,
                                  int format, int channels, int stride) {
  const size_t row = (size_t)view.offset + (size_t)y * (size_t)view.rowPitch;
  float3L v;
#if QUELL_LANES == 1
  const size_t first = row + (size_t)column * (size_t)stride;
  v.x = loadComponent(data, first, format);
  v.y = channels >= 2 ? loadComponent(data, first + 1, format) : v.x;
  v.z = channels >= 3 ? loadComponent(data, first + 2, format) : channels == 1 ? v.x : 0.0f;
#else
  int columns[QUELL_LANES];
  float values[3][QUELL_LANES];
  STORE_VECTOR(column, columns);
  for (int lane = 0; lane < QUELL_LANES; ++lane) {
    const size_t first = row + (size_t)columns[lane] * (size_t)stride;
    for (int c = 0; c < 3; ++c)
      values[c][lane] = c < channels ? loadComponent(data, first + (size_t)c, format) : 0.0f;
  }
  v.x = LOAD_VECTOR(values[0]);
  v.y = channels >= 2 ? LOAD_VECTOR(values[1]) : v.x;
  v.z = channels == 1 ? v.x : LOAD_VECTOR(values[2]);
#endif
  return v;
}

// The bits of the one component of `lanes` pixels, from whichever format; lanes from `lanes` on are 0.
QUELL_INLINE intL loadWords(__global const void* data, ImageViewParams view, int x, int y, int lanes,
                            int format, int stride) {
  const size_t first = pixelComponent(view, x, y, stride);
  __global const int* words = (__global const int*)data;
  __global const ushort* halves = (__global const ushort*)data;
#if QUELL_LANES == 1
  return format == QUELL_FORMAT_HALF ? (int)halves[first] : words[first];
#else
  if (lanes == QUELL_LANES && stride == 1 && format != QUELL_FORMAT_HALF)
    return LOAD_GLOBAL(int, words + first);
  int values[QUELL_LANES];
  for (int lane = 0; lane < QUELL_LANES; ++lane) {
    const size_t component = first + (size_t)(lane * stride);
    values[lane] = lane >= lanes                 ? 0
                   : format == QUELL_FORMAT_HALF ? (int)halves[component]
                                                 : words[component];
  }
  return LOAD_VECTOR(values);
#endif
}

// Stores `lanes` pixels. A fourth component becomes 1; with fewer than three the rest is dropped. Half outputs are
// clamped to the largest finite half by the caller.
QUELL_INLINE void storePixels(float3L value, __global void* data, ImageViewParams view, int x, int y,
                              int lanes, int format, int channels, int stride) {
  const size_t first = pixelComponent(view, x, y, stride);
#if QUELL_LANES > 1
  if (lanes == QUELL_LANES && channels == 3 && stride == 3) {
    storePacked3(value, data, first, format);
    return;
  }
  if (lanes == QUELL_LANES && channels == 4 && stride == 4) {
    storePacked4(value, data, first, format);
    return;
  }
  float components[3][QUELL_LANES];
  STORE_VECTOR(value.x, components[0]);
  STORE_VECTOR(value.y, components[1]);
  STORE_VECTOR(value.z, components[2]);
  for (int lane = 0; lane < lanes; ++lane) {
    for (int c = 0; c < channels; ++c)
      storeComponent(c < 3 ? components[c][lane] : 1.0f, data, first + (size_t)(lane * stride + c), format);
  }
#else
  storeComponent(value.x, data, first, format);
  if (channels >= 2) storeComponent(value.y, data, first + 1, format);
  if (channels >= 3) storeComponent(value.z, data, first + 2, format);
  if (channels >= 4) storeComponent(1.0f, data, first + 3, format);
#endif
}

// Spares a kernel from naming the compile options one by one.
#define LOAD_PIXELS(NAME, data, view, x, y, lanes) \
  loadPixels((data), (view), (x), (y), (lanes), NAME##_FORMAT, NAME##_CHANNELS, NAME##_STRIDE)
#define GATHER_PIXELS(NAME, data, view, column, y) \
  gatherPixels((data), (view), (column), (y), NAME##_FORMAT, NAME##_CHANNELS, NAME##_STRIDE)
#define LOAD_WORDS(NAME, data, view, x, y, lanes) \
  loadWords((data), (view), (x), (y), (lanes), NAME##_FORMAT, NAME##_STRIDE)
#define STORE_PIXELS(NAME, value, data, view, x, y, lanes) \
  storePixels((value), (data), (view), (x), (y), (lanes), NAME##_FORMAT, NAME##_CHANNELS, NAME##_STRIDE)

#endif

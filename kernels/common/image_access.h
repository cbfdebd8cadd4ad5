// The caller's images: loads and stores of QUELL_LANES neighbouring pixels in any layout of the buffer contract.
//
// A kernel that touches the image NAME is compiled with NAME_FORMAT (0 absent, 1 float, 2 half, 3 32-bit unsigned),
// NAME_CHANNELS (1-4) and NAME_STRIDE (components from one pixel to the next). Packed layouts take vector loads;
// anything else, and the end of a row, is read component by component.
#ifndef QUELL_COMMON_IMAGE_ACCESS_H
#define QUELL_COMMON_IMAGE_ACCESS_H

#include "common/lanes.h"
#include "common/types.h"

#define QUELL_FORMAT_FLOAT 1
#define QUELL_FORMAT_HALF 2
#define QUELL_FORMAT_UINT 3

QUELL_INLINE float loadComponent(__global const void* data, size_t component, int format) {
  return format == QUELL_FORMAT_HALF ? vload_half(component, (__global const half*)data)
                                     : ((__global const float*)data)[component];
}

QUELL_INLINE void storeComponent(float value, __global void* data, size_t component, int format) {
  if (format == QUELL_FORMAT_HALF) {
    vstore_half(value, component, (__global half*)data);
  } else {
    ((__global float*)data)[component] = value;
  }
}

#if QUELL_LANES == 16
QUELL_INLINE float16 loadComponents16(__global const void* data, size_t component, int format) {
  return format == QUELL_FORMAT_HALF ? vload_half16(0, (__global const half*)data + component)
                                     : vload16(0, (__global const float*)data + component);
}

QUELL_INLINE void storeComponents16(float16 value, __global void* data, size_t component, int format) {
  if (format == QUELL_FORMAT_HALF) {
    vstore_half16(value, 0, (__global half*)data + component);
  } else {
    vstore16(value, 0, (__global float*)data + component);
  }
}

QUELL_INLINE float3L loadPacked2(__global const void* data, size_t component, int format) {
  const float16 a = loadComponents16(data, component, format);
  const float16 b = loadComponents16(data, component + 16, format);
  float3L v;
  v.x = (float16)(a.even, b.even);
  v.y = (float16)(a.odd, b.odd);
  v.z = ZERO_LANES;
  return v;
}

QUELL_INLINE float3L loadPacked3(__global const void* data, size_t component, int format) {
  const float16 a = loadComponents16(data, component, format);
  const float16 b = loadComponents16(data, component + 16, format);
  const float16 c = loadComponents16(data, component + 32, format);
  float3L v;
  v.x = (float16)(a.s0369, a.scf, b.s258b, b.se, c.s147a, c.sd);
  v.y = (float16)(a.s147a, a.sd, b.s0369, b.scf, c.s258b, c.se);
  v.z = (float16)(a.s258b, a.se, b.s147a, b.sd, c.s0369, c.scf);
  return v;
}

QUELL_INLINE float3L loadPacked4(__global const void* data, size_t component, int format) {
  const float16 a = loadComponents16(data, component, format);
  const float16 b = loadComponents16(data, component + 16, format);
  const float16 c = loadComponents16(data, component + 32, format);
  const float16 d = loadComponents16(data, component + 48, format);
  float3L v;
  v.x = (float16)(a.s048c, b.s048c, c.s048c, d.s048c);
  v.y = (float16)(a.s159d, b.s159d, c.s159d, d.s159d);
  v.z = (float16)(a.s26ae, b.s26ae, c.s26ae, d.s26ae);
  return v;
}

QUELL_INLINE void storePacked3(float3L v, __global void* data, size_t component, int format) {
  const float16 x = v.x, y = v.y, z = v.z;
  storeComponents16((float16)(x.s0, y.s0, z.s0, x.s1, y.s1, z.s1, x.s2, y.s2, z.s2, x.s3, y.s3, z.s3, x.s4,
                              y.s4, z.s4, x.s5),
                    data, component, format);
  storeComponents16((float16)(y.s5, z.s5, x.s6, y.s6, z.s6, x.s7, y.s7, z.s7, x.s8, y.s8, z.s8, x.s9, y.s9,
                              z.s9, x.sa, y.sa),
                    data, component + 16, format);
  storeComponents16((float16)(z.sa, x.sb, y.sb, z.sb, x.sc, y.sc, z.sc, x.sd, y.sd, z.sd, x.se, y.se, z.se,
                              x.sf, y.sf, z.sf),
                    data, component + 32, format);
}

QUELL_INLINE void storePacked4(float3L v, __global void* data, size_t component, int format) {
  const float16 x = v.x, y = v.y, z = v.z;
  storeComponents16((float16)(x.s0, y.s0, z.s0, 1.0f, x.s1, y.s1, z.s1, 1.0f, x.s2, y.s2, z.s2, 1.0f, x.s3,
                              y.s3, z.s3, 1.0f),
                    data, component, format);
  storeComponents16((float16)(x.s4, y.s4, z.s4, 1.0f, x.s5, y.s5, z.s5, 1.0f, x.s6, y.s6, z.s6, 1.0f, x.s7,
                              y.s7, z.s7, 1.0f),
                    data, component + 16, format);
  storeComponents16((float16)(x.s8, y.s8, z.s8, 1.0f, x.s9, y.s9, z.s9, 1.0f, x.sa, y.sa, z.sa, 1.0f, x.sb,
                              y.sb, z.sb, 1.0f),
                    data, component + 32, format);
  storeComponents16((float16)(x.sc, y.sc, z.sc, 1.0f, x.sd, y.sd, z.sd, 1.0f, x.se, y.se, z.se, 1.0f, x.sf,
                              y.sf, z.sf, 1.0f),
                    data, component + 48, format);
}
#endif

// One component of `lanes` pixels; the other lanes are 0.
QUELL_INLINE floatL loadStrided(__global const void* data, size_t component, int format, int stride,
                                int lanes) {
#if QUELL_LANES == 1
  return loadComponent(data, component, format);
#else
  float values[16];
  for (int lane = 0; lane < 16; ++lane)
    values[lane] = lane < lanes ? loadComponent(data, component + (size_t)(lane * stride), format) : 0.0f;
  return vload16(0, values);
#endif
}

// Loads `lanes` pixels from column x of row y: three components; one component is spread over all three, a missing
// third is 0. Lanes from `lanes` on are 0.
QUELL_INLINE float3L loadPixels(__global const void* data, ImageViewParams view, int x, int y, int lanes,
                                int format, int channels, int stride) {
  const size_t first = (size_t)view.offset + (size_t)y * (size_t)view.rowPitch + (size_t)x * (size_t)stride;
#if QUELL_LANES == 16
  if (lanes == 16) {
    if (channels == 2 && stride == 2) return loadPacked2(data, first, format);
    if (channels == 3 && stride == 3) return loadPacked3(data, first, format);
    if (channels == 4 && stride == 4) return loadPacked4(data, first, format);
    if (channels == 1 && stride == 1) {
      float3L grey;
      grey.x = loadComponents16(data, first, format);
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
  int columns[16];
  float values[3][16];
  vstore16(column, 0, columns);
  for (int lane = 0; lane < 16; ++lane) {
    const size_t first = row + (size_t)columns[lane] * (size_t)stride;
    for (int c = 0; c < 3; ++c)
      values[c][lane] = c < channels ? loadComponent(data, first + (size_t)c, format) : 0.0f;
  }
  v.x = vload16(0, values[0]);
  v.y = channels >= 2 ? vload16(0, values[1]) : v.x;
  v.z = channels == 1 ? v.x : vload16(0, values[2]);
#endif
  return v;
}

// The bits of the one component of `lanes` pixels, from whichever format; lanes from `lanes` on are 0.
QUELL_INLINE intL loadWords(__global const void* data, ImageViewParams view, int x, int y, int lanes,
                            int format, int stride) {
  const size_t first = (size_t)view.offset + (size_t)y * (size_t)view.rowPitch + (size_t)x * (size_t)stride;
  __global const int* words = (__global const int*)data;
  __global const ushort* halves = (__global const ushort*)data;
#if QUELL_LANES == 1
  return format == QUELL_FORMAT_HALF ? (int)halves[first] : words[first];
#else
  if (lanes == 16 && stride == 1 && format != QUELL_FORMAT_HALF) return vload16(0, words + first);
  int values[16];
  for (int lane = 0; lane < 16; ++lane) {
    const size_t component = first + (size_t)(lane * stride);
    values[lane] = lane >= lanes                 ? 0
                   : format == QUELL_FORMAT_HALF ? (int)halves[component]
                                                 : words[component];
  }
  return vload16(0, values);
#endif
}

// Stores `lanes` pixels. A fourth component becomes 1; with fewer than three the rest is dropped. Half outputs are
// clamped to the largest finite half by the caller.
QUELL_INLINE void storePixels(float3L value, __global void* data, ImageViewParams view, int x, int y,
                              int lanes, int format, int channels, int stride) {
  const size_t first = (size_t)view.offset + (size_t)y * (size_t)view.rowPitch + (size_t)x * (size_t)stride;
#if QUELL_LANES == 16
  if (lanes == 16 && channels == 3 && stride == 3) {
    storePacked3(value, data, first, format);
    return;
  }
  if (lanes == 16 && channels == 4 && stride == 4) {
    storePacked4(value, data, first, format);
    return;
  }
  float components[3][16];
  vstore16(value.x, 0, components[0]);
  vstore16(value.y, 0, components[1]);
  vstore16(value.z, 0, components[2]);
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

// Packed pixels in memory to one vector a component and back, for QUELL_LANES pixels at a time.
#ifndef QUELL_COMMON_PACKED_PIXELS_H
#define QUELL_COMMON_PACKED_PIXELS_H

#include "common/lanes.h"

#define QUELL_FORMAT_FLOAT 1
#define QUELL_FORMAT_HALF 2
#define QUELL_FORMAT_UINT 3
#define QUELL_FORMAT_OBJECT 4

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

#if QUELL_LANES > 1
// Component i of pixel p is element n * p + i of the n vectors a, b, ... together.
#if QUELL_LANES == 16
#define FIRST_OF_THREE(a, b, c) (a).s0369, (a).scf, (b).s258b, (b).se, (c).s147a, (c).sd
#define SECOND_OF_THREE(a, b, c) (a).s147a, (a).sd, (b).s0369, (b).scf, (c).s258b, (c).se
#define THIRD_OF_THREE(a, b, c) (a).s258b, (a).se, (b).s147a, (b).sd, (c).s0369, (c).scf
#define THREE_FIRST(x, y, z) \
  x.s0, y.s0, z.s0, x.s1, y.s1, z.s1, x.s2, y.s2, z.s2, x.s3, y.s3, z.s3, x.s4, y.s4, z.s4, x.s5
#define THREE_SECOND(x, y, z) \
  y.s5, z.s5, x.s6, y.s6, z.s6, x.s7, y.s7, z.s7, x.s8, y.s8, z.s8, x.s9, y.s9, z.s9, x.sa, y.sa
#define THREE_THIRD(x, y, z) \
  z.sa, x.sb, y.sb, z.sb, x.sc, y.sc, z.sc, x.sd, y.sd, z.sd, x.se, y.se, z.se, x.sf, y.sf, z.sf
#elif QUELL_LANES == 8
#define FIRST_OF_THREE(a, b, c) (a).s036, (b).s147, (c).s25
#define SECOND_OF_THREE(a, b, c) (a).s147, (b).s25, (c).s036
#define THIRD_OF_THREE(a, b, c) (a).s25, (b).s036, (c).s147
#define THREE_FIRST(x, y, z) x.s0, y.s0, z.s0, x.s1, y.s1, z.s1, x.s2, y.s2
#define THREE_SECOND(x, y, z) z.s2, x.s3, y.s3, z.s3, x.s4, y.s4, z.s4, x.s5
#define THREE_THIRD(x, y, z) y.s5, z.s5, x.s6, y.s6, z.s6, x.s7, y.s7, z.s7
#elif QUELL_LANES == 4
#define FIRST_OF_THREE(a, b, c) (a).s03, (b).s2, (c).s1
#define SECOND_OF_THREE(a, b, c) (a).s1, (b).s03, (c).s2
#define THIRD_OF_THREE(a, b, c) (a).s2, (b).s1, (c).s03
#define THREE_FIRST(x, y, z) x.s0, y.s0, z.s0, x.s1
#define THREE_SECOND(x, y, z) y.s1, z.s1, x.s2, y.s2
#define THREE_THIRD(x, y, z) z.s2, x.s3, y.s3, z.s3
#endif

QUELL_INLINE floatL loadComponents(__global const void* data, size_t component, int format) {
  return format == QUELL_FORMAT_HALF ? TYPE_OF_LANES(vload_half)(0, (__global const half*)data + component)
                                     : LOAD_GLOBAL(float, (__global const float*)data + component);
}

QUELL_INLINE void storeComponents(floatL value, __global void* data, size_t component, int format) {
  if (format == QUELL_FORMAT_HALF) {
    TYPE_OF_LANES(vstore_half)(value, 0, (__global half*)data + component);
  } else {
    STORE_GLOBAL(float, value, (__global float*)data + component);
  }
}

QUELL_INLINE float3L loadPacked2(__global const void* data, size_t component, int format) {
  const floatL a = loadComponents(data, component, format);
  const floatL b = loadComponents(data, component + QUELL_LANES, format);
  float3L v;
  v.x = (floatL)(a.even, b.even);
  v.y = (floatL)(a.odd, b.odd);
  v.z = ZERO_LANES;
  return v;
}

QUELL_INLINE float3L loadPacked3(__global const void* data, size_t component, int format) {
  const floatL a = loadComponents(data, component, format);
  const floatL b = loadComponents(data, component + QUELL_LANES, format);
  const floatL c = loadComponents(data, component + 2 * QUELL_LANES, format);
  float3L v;
  v.x = (floatL)(FIRST_OF_THREE(a, b, c));
  v.y = (floatL)(SECOND_OF_THREE(a, b, c));
  v.z = (floatL)(THIRD_OF_THREE(a, b, c));
  return v;
}

QUELL_INLINE float3L loadPacked4(__global const void* data, size_t component, int format) {
  const floatL a = loadComponents(data, component, format);
  const floatL b = loadComponents(data, component + QUELL_LANES, format);
  const floatL c = loadComponents(data, component + 2 * QUELL_LANES, format);
  const floatL d = loadComponents(data, component + 3 * QUELL_LANES, format);
  float3L v;
  v.x = (floatL)(a.even.even, b.even.even, c.even.even, d.even.even);
  v.y = (floatL)(a.odd.even, b.odd.even, c.odd.even, d.odd.even);
  v.z = (floatL)(a.even.odd, b.even.odd, c.even.odd, d.even.odd);
  return v;
}

QUELL_INLINE void storePacked3(float3L v, __global void* data, size_t component, int format) {
  storeComponents((floatL)(THREE_FIRST(v.x, v.y, v.z)), data, component, format);
  storeComponents((floatL)(THREE_SECOND(v.x, v.y, v.z)), data, component + QUELL_LANES, format);
  storeComponents((floatL)(THREE_THIRD(v.x, v.y, v.z)), data, component + 2 * QUELL_LANES, format);
}

// Elements of a and b in turns, from their lower and from their upper halves.
QUELL_INLINE floatL lowerInTurns(floatL a, floatL b) {
  floatL v;
  v.even = a.lo;
  v.odd = b.lo;
  return v;
}
QUELL_INLINE floatL upperInTurns(floatL a, floatL b) {
  floatL v;
  v.even = a.hi;
  v.odd = b.hi;
  return v;
}

// The fourth component is 1.
QUELL_INLINE void storePacked4(float3L v, __global void* data, size_t component, int format) {
  const floatL lowXz = lowerInTurns(v.x, v.z);
  const floatL highXz = upperInTurns(v.x, v.z);
  const floatL lowYw = lowerInTurns(v.y, ONE_LANES);
  const floatL highYw = upperInTurns(v.y, ONE_LANES);
  storeComponents(lowerInTurns(lowXz, lowYw), data, component, format);
  storeComponents(upperInTurns(lowXz, lowYw), data, component + QUELL_LANES, format);
  storeComponents(lowerInTurns(highXz, highYw), data, component + 2 * QUELL_LANES, format);
  storeComponents(upperInTurns(highXz, highYw), data, component + 3 * QUELL_LANES, format);
}
#endif

#endif

// Lanes: every per-pixel kernel is written once for QUELL_LANES neighbouring pixels of a row.
//
// QUELL_LANES is 1 on GPUs (one pixel a work-item, neighbouring work-items on neighbouring pixels: coalesced) and
// what fills a vector register, 4, 8 or 16, on CPU devices, whose compilers leave one-pixel work-items scalar and keep
// wider ones in memory. floatL, intL and uintL are the value types.
// A comparison gives 1 per lane with one lane and -1 with several, as OpenCL C defines; so masks are only ever
// combined with && and || and used in ?:, which means the same for both. Ternaries take the place of fmin, fmax,
// clamp and floor, which some CPU runtimes keep as calls.
#ifndef QUELL_COMMON_LANES_H
#define QUELL_COMMON_LANES_H

// Helpers that take or return many lanes pass them through memory unless they are inlined, whatever the compiler
// thinks of their size: accumulate_noisy takes 1.3 times as long without.
// Oclgrind's compiler cannot take the result, hence the way out.
#ifdef QUELL_PLAIN_INLINE
#define QUELL_INLINE static inline
#else
#define QUELL_INLINE static inline __attribute__((always_inline))
#endif

#if QUELL_LANES == 1
typedef float floatL;
typedef int intL;
typedef uint uintL;
#define LANE_INDEX 0
#define TO_INT(v) convert_int(v)
#define TO_FLOAT(v) convert_float(v)
#define TO_UCHAR(v) convert_uchar(v)
#define AS_INT(v) as_int(v)
#define AS_FLOAT(v) as_float(v)
#define AS_UINT(v) as_uint(v)
#define TRUE_LANES 1
#else
// TYPE_OF_LANES(float) is float16 where there are sixteen, and so are names of functions.
#define JOIN_NAMES(name, lanes) name##lanes
#define JOIN(name, lanes) JOIN_NAMES(name, lanes)
#define TYPE_OF_LANES(name) JOIN(name, QUELL_LANES)
typedef TYPE_OF_LANES(float) floatL;
typedef TYPE_OF_LANES(int) intL;
typedef TYPE_OF_LANES(uint) uintL;
#define TO_INT(v) TYPE_OF_LANES(convert_int)(v)
#define TO_FLOAT(v) TYPE_OF_LANES(convert_float)(v)
#define TO_UCHAR(v) TYPE_OF_LANES(convert_uchar)(v)
#define AS_INT(v) TYPE_OF_LANES(as_int)(v)
#define AS_FLOAT(v) TYPE_OF_LANES(as_float)(v)
#define AS_UINT(v) TYPE_OF_LANES(as_uint)(v)
#define LOAD_VECTOR(p) TYPE_OF_LANES(vload)(0, p)
#define STORE_VECTOR(v, p) TYPE_OF_LANES(vstore)(v, 0, p)
#define TRUE_LANES ((intL)(-1))
// As many consecutive elements of global memory as there are lanes, wherever they begin. PoCL's vloadn and vstoren take
// vectors apart into pieces of 16 bytes.
typedef struct __attribute__((packed)) floatAnywhere {
  floatL lanes;
} floatAnywhere;
typedef struct __attribute__((packed)) intAnywhere {
  intL lanes;
} intAnywhere;
typedef struct __attribute__((packed)) ucharAnywhere {
  TYPE_OF_LANES(uchar) lanes;
} ucharAnywhere;
#define LOAD_GLOBAL(type, p) (((__global const type##Anywhere*)(p))->lanes)
#define STORE_GLOBAL(type, v, p) ((__global type##Anywhere*)(p))->lanes = (v)
// M(0), M(1), ... for every lane, in hexadecimal as OpenCL C numbers the elements of a vector.
#if QUELL_LANES == 16
#define EACH_LANE(M) \
  M(0), M(1), M(2), M(3), M(4), M(5), M(6), M(7), M(8), M(9), M(a), M(b), M(c), M(d), M(e), M(f)
#define LAST_LANE(v) (v).sf
#elif QUELL_LANES == 8
#define EACH_LANE(M) M(0), M(1), M(2), M(3), M(4), M(5), M(6), M(7)
#define LAST_LANE(v) (v).s7
#elif QUELL_LANES == 4
#define EACH_LANE(M) M(0), M(1), M(2), M(3)
#define LAST_LANE(v) (v).s3
#else
#error "QUELL_LANES must be 1, 4, 8 or 16"
#endif
#define LANE_NUMBER(i) 0x##i
#define LANE_INDEX ((intL)(EACH_LANE(LANE_NUMBER)))
#endif
#define SQRT(v) sqrt(v)

typedef struct float3L {
  floatL x, y, z;
} float3L;

// On GPUs short loops over arrays must be unrolled: an array that is indexed by a variable lies in memory, not in
// registers. CPUs have it in a cache; there, unrolled code would only be longer.
#if QUELL_LANES == 1
#define UNROLL_ON_GPU _Pragma("unroll")
#else
#define UNROLL_ON_GPU
#endif

#define ZERO_LANES ((floatL)(0.0f))
#define ONE_LANES ((floatL)(1.0f))

QUELL_INLINE floatL minLanes(floatL a, floatL b) { return a < b ? a : b; }
QUELL_INLINE floatL maxLanes(floatL a, floatL b) { return a > b ? a : b; }
QUELL_INLINE floatL clampLanes(floatL v, float low, float high) {
  return minLanes(maxLanes(v, (floatL)(low)), (floatL)(high));
}
QUELL_INLINE floatL absLanes(floatL v) { return AS_FLOAT(AS_INT(v) & 0x7fffffff); }
QUELL_INLINE intL minLanesInt(intL a, intL b) { return a < b ? a : b; }
QUELL_INLINE intL maxLanesInt(intL a, intL b) { return a > b ? a : b; }

// Largest integer not above v. |v| must be below 2^31.
QUELL_INLINE intL floorLanes(floatL v) {
  const intL truncated = TO_INT(v);
  return truncated - (v < TO_FLOAT(truncated) ? (intL)(1) : (intL)(0));
}

// True where v is neither NaN nor Inf. Tests the exponent bits: v != v may be folded away by a compiler that assumes
// finite arithmetic.
QUELL_INLINE intL isFinite(floatL v) { return (AS_INT(v) & 0x7f800000) != 0x7f800000; }

QUELL_INLINE int anyLane(intL mask) {
#if QUELL_LANES == 1
  return mask;
#else
  return any(mask);
#endif
}

QUELL_INLINE float3L splat3(float v) {
  float3L result;
  result.x = (floatL)(v);
  result.y = (floatL)(v);
  result.z = (floatL)(v);
  return result;
}
QUELL_INLINE float3L add3(float3L a, float3L b) {
  a.x += b.x;
  a.y += b.y;
  a.z += b.z;
  return a;
}
QUELL_INLINE float3L subtract3(float3L a, float3L b) {
  a.x -= b.x;
  a.y -= b.y;
  a.z -= b.z;
  return a;
}
QUELL_INLINE float3L multiply3(float3L a, float3L b) {
  a.x *= b.x;
  a.y *= b.y;
  a.z *= b.z;
  return a;
}
QUELL_INLINE float3L scale3(float3L a, floatL s) {
  a.x *= s;
  a.y *= s;
  a.z *= s;
  return a;
}
QUELL_INLINE float3L select3(intL mask, float3L a, float3L b) {
  a.x = mask ? a.x : b.x;
  a.y = mask ? a.y : b.y;
  a.z = mask ? a.z : b.z;
  return a;
}
QUELL_INLINE float3L clamp3(float3L a, float low, float high) {
  a.x = clampLanes(a.x, low, high);
  a.y = clampLanes(a.y, low, high);
  a.z = clampLanes(a.z, low, high);
  return a;
}
QUELL_INLINE floatL dot3(float3L a, float3L b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
QUELL_INLINE intL isFinite3(float3L v) { return isFinite(v.x) && isFinite(v.y) && isFinite(v.z); }

#endif

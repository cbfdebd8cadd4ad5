// Random numbers, and warps from the unit square to directions.
#ifndef QUELL_RENDER_SAMPLING_H
#define QUELL_RENDER_SAMPLING_H

#include "common/random.h"

#define QUELL_PI 3.14159265358979f

typedef struct Random {
  uint state;
} Random;

// A stream of its own for every seed (mixed with the frame), pixel and sample.
static inline Random randomFor(uint seed, uint pixel, uint sample) {
  Random random;
  random.state = hashScalar(pixel + hashScalar(sample + hashScalar(seed)));
  return random;
}

// The next number of the stream, uniform in [0, 1): a counter through a hash.
static inline float nextUniform(Random* random) {
  random->state += 0x9e3779b9u;                                             // 2^32 / golden ratio
  return (float)(hashScalar(random->state) >> 8) * 5.9604644775390625e-8f;  // 2^-24
}

static inline float2 nextUniform2(Random* random) {
  const float x = nextUniform(random);
  return (float2)(x, nextUniform(random));
}

// Unit vectors t and b that make a right-handed frame with n (Duff et al. 2017, Building an Orthonormal Basis, Revisited).
static inline void basisOf(float3 n, float3* t, float3* b) {
  const float s = n.z >= 0.0f ? 1.0f : -1.0f;
  const float a = -1.0f / (s + n.z);
  const float c = n.x * n.y * a;
  *t = (float3)(1.0f + s * n.x * n.x * a, s * c, -s * n.x);
  *b = (float3)(c, s + n.y * n.y * a, -n.y);
}

static inline float3 toWorld(float3 v, float3 n) {
  float3 t, b;
  basisOf(n, &t, &b);
  return v.x * t + v.y * b + v.z * n;
}

// About n, with density cos / pi.
static inline float3 sampleCosine(float2 u, float3 n) {
  const float radius = sqrt(u.x);
  const float angle = 2.0f * QUELL_PI * u.y;
  const float3 v = (float3)(radius * cos(angle), radius * sin(angle), sqrt(max(0.0f, 1.0f - u.x)));
  return normalize(toWorld(v, n));
}

static inline float cosinePdf(float cosine) { return max(cosine, 0.0f) / QUELL_PI; }

// 1 - cosine of a small angle from its squared sine, without cancellation.
static inline float oneMinusCosine(float sineSquared) {
  return sineSquared / (1.0f + sqrt(max(0.0f, 1.0f - sineSquared)));
}

// Uniform in a cone about the axis; versine: 1 - cosine of its half angle.
static inline float3 sampleCone(float2 u, float3 axis, float versine) {
  const float fall = u.x * versine;
  const float sine = sqrt(max(0.0f, fall * (2.0f - fall)));
  const float angle = 2.0f * QUELL_PI * u.y;
  return normalize(toWorld((float3)(sine * cos(angle), sine * sin(angle), 1.0f - fall), axis));
}

static inline float conePdf(float versine) { return 1.0f / (2.0f * QUELL_PI * versine); }

#endif

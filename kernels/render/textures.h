// Procedural patterns on surfaces.
#ifndef QUELL_RENDER_TEXTURES_H
#define QUELL_RENDER_TEXTURES_H

#include "common/random.h"
#include "render/scene_params.h"

#define QUELL_NOISE_OCTAVES 4
// Bricks: length per height, and width of a joint per height.
#define QUELL_BRICK_LENGTH 2.5f
#define QUELL_BRICK_JOINT 0.08f

// A hash of a lattice point as a number in [0, 1); the primes are those of Teschner et al. 2003.
static inline float latticeValue(int x, int y, int z) {
  const uint key = ((uint)x * 73856093u) ^ ((uint)y * 19349663u) ^ ((uint)z * 83492791u);
  return (float)(hashScalar(key) >> 8) * 5.9604644775390625e-8f;  // 2^-24
}

// Value noise: lattice values joined by smooth cubics; period 1, in [0, 1).
static inline float valueNoise(float3 p) {
  const float3 cell = floor(p);
  const float3 f = p - cell;
  const float3 s = f * f * (3.0f - 2.0f * f);
  const int x = (int)cell.x, y = (int)cell.y, z = (int)cell.z;
  const float near = mix(mix(latticeValue(x, y, z), latticeValue(x + 1, y, z), s.x),
                         mix(latticeValue(x, y + 1, z), latticeValue(x + 1, y + 1, z), s.x), s.y);
  const float far = mix(mix(latticeValue(x, y, z + 1), latticeValue(x + 1, y, z + 1), s.x),
                        mix(latticeValue(x, y + 1, z + 1), latticeValue(x + 1, y + 1, z + 1), s.x), s.y);
  return mix(near, far, s.z);
}

// Octaves of half the amplitude at twice the frequency; in [0, 1).
static inline float fractalNoise(float3 p) {
  float sum = 0.0f, amplitude = 0.5f, total = 0.0f;
  for (int octave = 0; octave < QUELL_NOISE_OCTAVES; ++octave) {
    sum += amplitude * valueNoise(p);
    total += amplitude;
    amplitude *= 0.5f;
    p = 2.0f * p + 17.3f;  // any shift: octaves must not share their lattice planes
  }
  return sum / total;
}

// Planar coordinates of a surface point (m): along the surface of cylinders, else seen along the main axis of the normal.
static inline float2 planarCoordinates(int shape, float4 size, float3 p, float3 n) {
  const float3 a = fabs(n);
  if (shape == QUELL_SHAPE_CYLINDER && a.z < 0.5f) return (float2)(size.x * atan2(p.y, p.x), p.z);
  if (a.z >= a.x && a.z >= a.y) return p.xy;
  return a.x > a.y ? p.yz : p.xz;
}

static inline float bricks(float2 p) {
  const float row = floor(p.y);
  const float along =
      p.x / QUELL_BRICK_LENGTH + 0.5f * (row - 2.0f * floor(0.5f * row));  // every other row by half
  const float column = floor(along);
  const float fromSide = (along - column) * QUELL_BRICK_LENGTH;
  const float fromBed = p.y - row;
  const float edge = fmin(fmin(fromSide, QUELL_BRICK_LENGTH - fromSide), fmin(fromBed, 1.0f - fromBed));
  const float inside = clamp(edge / QUELL_BRICK_JOINT - 0.5f, 0.0f, 1.0f);
  return inside * (0.5f + 0.5f * latticeValue((int)column, (int)row, 7));
}

static inline float patternAt(int pattern, float3 p, float2 uv) {
  switch (pattern) {
    case QUELL_PATTERN_NOISE:
      return fractalNoise(p);
    case QUELL_PATTERN_PATCHES:
      return smoothstep(0.46f, 0.54f, fractalNoise(p));
    case QUELL_PATTERN_CHECKER:
      return (float)(((int)floor(uv.x) + (int)floor(uv.y)) & 1);
    case QUELL_PATTERN_STRIPES:
      return 0.5f + 0.5f * sin(6.28318531f * uv.x);
    case QUELL_PATTERN_RAMP:
      return fabs(2.0f * (uv.x - floor(uv.x)) - 1.0f);
    case QUELL_PATTERN_BRICKS:
      return bricks(uv);
    case QUELL_PATTERN_TILES:
      return latticeValue((int)floor(uv.x), (int)floor(uv.y), 3);
    case QUELL_PATTERN_MARBLE:
      return pow(0.5f + 0.5f * sin(6.28318531f * (p.x + 2.5f * fractalNoise(2.0f * p))), 3.0f);
    default:
      return 0.0f;
  }
}

// The texture at a point of a surface, object space. Where a period is not much wider than a pixel (footprint, m) the
// pattern fades to its middle, as the mip map of an image would.
static inline float textureAt(__global const RenderTexture* texture, int shape, float4 size, float3 p,
                              float3 n, float footprint) {
  if (texture->pattern == QUELL_PATTERN_CONSTANT) return texture->low;
  const float scale = texture->scale;
  const float value = patternAt(texture->pattern, scale * p, scale * planarCoordinates(shape, size, p, n));
  const float faded = mix(value, 0.5f, smoothstep(0.3f, 1.0f, scale * footprint));
  return mix(texture->low, texture->high, faded);
}

#endif

// Where a ray meets a shape, and the shape's normal, in object space.
#ifndef QUELL_RENDER_SHAPES_H
#define QUELL_RENDER_SHAPES_H

#include "render/scene_params.h"

// Sphere tracing (Hart 1996) ends at this distance from the surface (m), or after this many steps.
#define QUELL_MARCH_DISTANCE 5e-5f
#define QUELL_MARCH_STEPS 128
// A point of a closed cylinder this close to a cap (m) lies on it.
#define QUELL_CAP_DISTANCE 1e-4f

typedef struct Ray {
  float3 origin;
  float3 direction;  // unit length
} Ray;

// Distance along the ray, beyond `least` (m); INFINITY for none.

static inline float hitSphere(Ray ray, float radius, float least) {
  const float along = dot(ray.origin, ray.direction);
  const float3 nearest = ray.origin - along * ray.direction;  // keeps precision far from the sphere
  const float square = radius * radius - dot(nearest, nearest);
  if (square < 0.0f) return INFINITY;
  const float half_chord = sqrt(square);
  if (-along - half_chord > least) return -along - half_chord;
  return -along + half_chord > least ? -along + half_chord : INFINITY;
}

// Entry and exit of the ray through a box about the origin; no overlap: entry > exit.
static inline float2 boxInterval(Ray ray, float3 halfExtents) {
  const float3 d = ray.direction;
  // A ray within a face's plane must not become 0 times infinity.
  const float3 safe = (float3)(fabs(d.x) > 1e-12f ? d.x : 1e-12f, fabs(d.y) > 1e-12f ? d.y : 1e-12f,
                               fabs(d.z) > 1e-12f ? d.z : 1e-12f);
  const float3 inverse = 1.0f / safe;
  const float3 a = (-halfExtents - ray.origin) * inverse;
  const float3 b = (halfExtents - ray.origin) * inverse;
  const float3 low = fmin(a, b);
  const float3 high = fmax(a, b);
  return (float2)(fmax(low.x, fmax(low.y, low.z)), fmin(high.x, fmin(high.y, high.z)));
}

static inline float hitBox(Ray ray, float3 halfExtents, float least) {
  const float2 interval = boxInterval(ray, halfExtents);
  if (interval.x > interval.y) return INFINITY;
  if (interval.x > least) return interval.x;
  return interval.y > least ? interval.y : INFINITY;
}

static inline float hitRectangle(Ray ray, float2 halfExtents, float least) {
  const float distance = -ray.origin.z / ray.direction.z;
  if (!(distance > least)) return INFINITY;
  const float2 p = ray.origin.xy + distance * ray.direction.xy;
  return fabs(p.x) <= halfExtents.x && fabs(p.y) <= halfExtents.y ? distance : INFINITY;
}

static inline float hitDisc(Ray ray, float2 halfAxes, float least) {
  const float distance = -ray.origin.z / ray.direction.z;
  if (!(distance > least)) return INFINITY;
  const float2 p = (ray.origin.xy + distance * ray.direction.xy) / halfAxes;
  return dot(p, p) <= 1.0f ? distance : INFINITY;
}

static inline float hitCylinder(Ray ray, float radius, float halfHeight, float least) {
  const float a = dot(ray.direction.xy, ray.direction.xy);
  float2 side = (float2)(-INFINITY, INFINITY);  // a ray along the axis is bounded by the caps alone
  const float distance2 = dot(ray.origin.xy, ray.origin.xy);
  if (a > 1e-12f) {
    const float along = dot(ray.origin.xy, ray.direction.xy) / a;
    const float2 nearest = ray.origin.xy - along * ray.direction.xy;
    const float square = radius * radius - dot(nearest, nearest);
    if (square < 0.0f) return INFINITY;
    const float half_chord = sqrt(square / a);
    side = (float2)(-along - half_chord, -along + half_chord);
  } else if (distance2 > radius * radius) {
    return INFINITY;
  }
  const float inverse = 1.0f / (fabs(ray.direction.z) > 1e-12f ? ray.direction.z : 1e-12f);
  const float a0 = (-halfHeight - ray.origin.z) * inverse;
  const float a1 = (halfHeight - ray.origin.z) * inverse;
  const float entry = fmax(side.x, fmin(a0, a1));
  const float exit = fmin(side.y, fmax(a0, a1));
  if (entry > exit) return INFINITY;
  if (entry > least) return entry;
  return exit > least ? exit : INFINITY;
}

// Signed distances (m), negative inside.
static inline float torusDistance(float3 p, float4 size) {
  const float2 q = (float2)(sqrt(p.x * p.x + p.y * p.y) - size.x, p.z);
  return sqrt(q.x * q.x + q.y * q.y) - size.y;
}

static inline float roundedBoxDistance(float3 p, float4 size) {
  const float3 q = fabs(p) - (size.xyz - size.w);
  const float3 outside = fmax(q, 0.0f);
  return sqrt(dot(outside, outside)) + fmin(fmax(q.x, fmax(q.y, q.z)), 0.0f) - size.w;
}

// Shapes without a simple closed form, from outside.
static inline float hitByMarching(int shape, Ray ray, float4 size, float least) {
  const float3 bounds =
      shape == QUELL_SHAPE_TORUS ? (float3)(size.x + size.y, size.x + size.y, size.y) : size.xyz;
  const float2 interval = boxInterval(ray, bounds);
  float distance = fmax(interval.x, least);
  for (int step = 0; step < QUELL_MARCH_STEPS && distance <= interval.y; ++step) {
    const float3 p = ray.origin + distance * ray.direction;
    const float gap = shape == QUELL_SHAPE_TORUS ? torusDistance(p, size) : roundedBoxDistance(p, size);
    distance += gap;
    if (gap < QUELL_MARCH_DISTANCE) return distance > least ? distance : INFINITY;
  }
  return INFINITY;
}

static inline float hitShape(int shape, float4 size, Ray ray, float least) {
  switch (shape) {
    case QUELL_SHAPE_SPHERE:
      return hitSphere(ray, size.x, least);
    case QUELL_SHAPE_BOX:
      return hitBox(ray, size.xyz, least);
    case QUELL_SHAPE_RECTANGLE:
      return hitRectangle(ray, size.xy, least);
    case QUELL_SHAPE_DISC:
      return hitDisc(ray, size.xy, least);
    case QUELL_SHAPE_CYLINDER:
      return hitCylinder(ray, size.x, size.y, least);
    default:
      return hitByMarching(shape, ray, size, least);
  }
}

static inline float3 boxNormal(float3 p, float3 halfExtents) {
  const float3 q = fabs(p) / halfExtents;
  if (q.x > q.y && q.x > q.z) return (float3)(p.x > 0.0f ? 1.0f : -1.0f, 0.0f, 0.0f);
  if (q.y > q.z) return (float3)(0.0f, p.y > 0.0f ? 1.0f : -1.0f, 0.0f);
  return (float3)(0.0f, 0.0f, p.z > 0.0f ? 1.0f : -1.0f);
}

static inline float3 torusNormal(float3 p, float4 size) {
  const float ring = fmax(sqrt(p.x * p.x + p.y * p.y), 1e-12f);
  return normalize((float3)(p.x * (1.0f - size.x / ring), p.y * (1.0f - size.x / ring), p.z));
}

// The outward unit normal at a point of the surface; flat shapes face +z.
static inline float3 shapeNormal(int shape, float4 size, float3 p) {
  switch (shape) {
    case QUELL_SHAPE_SPHERE:
      return normalize(p);
    case QUELL_SHAPE_BOX:
      return boxNormal(p, size.xyz);
    case QUELL_SHAPE_CYLINDER:
      if (fabs(p.z) > size.y - QUELL_CAP_DISTANCE) return (float3)(0.0f, 0.0f, p.z > 0.0f ? 1.0f : -1.0f);
      return normalize((float3)(p.x, p.y, 0.0f));
    case QUELL_SHAPE_TORUS:
      return torusNormal(p, size);
    case QUELL_SHAPE_ROUNDED_BOX:
      return normalize(p - clamp(p, size.w - size.xyz, size.xyz - size.w));
    default:
      return (float3)(0.0f, 0.0f, 1.0f);
  }
}

#endif

// Rays through the scene: a stack walk of the bounding volume hierarchy.
#ifndef QUELL_RENDER_TRAVERSE_H
#define QUELL_RENDER_TRAVERSE_H

#include "render/shapes.h"

// Nodes that wait at most; the host keeps the tree shallower (host/render/bvh.cpp).
#define QUELL_BVH_STACK 48
// Rays start this far from the surface they leave (m), along its normal.
#define QUELL_RAY_OFFSET 5e-4f

typedef struct Scene {
  __global const RenderBvhNode* nodes;
  __global const RenderPrimitive* primitives;
  __global const RenderMaterial* materials;
  __global const RenderLight* lights;
} Scene;

typedef struct Hit {
  float distance;  // m
  int primitive;   // -1: none
} Hit;

// Rows of a rigid transform (world to object) applied to a point, to a direction, and its inverse to each.
static inline float3 pointToObject(__global const float4* rows, float3 p) {
  return (float3)(dot(rows[0].xyz, p) + rows[0].w, dot(rows[1].xyz, p) + rows[1].w,
                  dot(rows[2].xyz, p) + rows[2].w);
}
static inline float3 directionToObject(__global const float4* rows, float3 v) {
  return (float3)(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v));
}
static inline float3 directionToWorld(__global const float4* rows, float3 v) {
  return v.x * rows[0].xyz + v.y * rows[1].xyz + v.z * rows[2].xyz;
}
static inline float3 pointToWorld(__global const float4* rows, float3 p) {
  return directionToWorld(rows, p - (float3)(rows[0].w, rows[1].w, rows[2].w));
}

static inline float hitPrimitive(__global const RenderPrimitive* primitive, Ray ray, float least) {
  Ray inner;
  inner.origin = pointToObject(primitive->toObject, ray.origin);
  inner.direction = directionToObject(primitive->toObject, ray.direction);
  return hitShape(primitive->shape, primitive->size, inner, least);
}

// Distance at which the ray enters a node's box, INFINITY if it misses it or is beyond `most`.
static inline float enterNode(__global const RenderBvhNode* node, float3 origin, float3 inverse, float most) {
  const float x0 = (node->low[0] - origin.x) * inverse.x, x1 = (node->high[0] - origin.x) * inverse.x;
  const float y0 = (node->low[1] - origin.y) * inverse.y, y1 = (node->high[1] - origin.y) * inverse.y;
  const float z0 = (node->low[2] - origin.z) * inverse.z, z1 = (node->high[2] - origin.z) * inverse.z;
  const float nearX = x0 < x1 ? x0 : x1, farX = x0 < x1 ? x1 : x0;
  const float nearY = y0 < y1 ? y0 : y1, farY = y0 < y1 ? y1 : y0;
  const float nearZ = z0 < z1 ? z0 : z1, farZ = z0 < z1 ? z1 : z0;
  float entry = nearX > nearY ? nearX : nearY;
  entry = entry > nearZ ? entry : nearZ;
  entry = entry > 0.0f ? entry : 0.0f;
  float exit = farX < farY ? farX : farY;
  exit = exit < farZ ? exit : farZ;
  exit = exit < most ? exit : most;
  return entry <= exit ? entry : INFINITY;
}

// The first hit nearer than `most`; with anyHit != 0 the first that is found. Shapes of the light `ignored` are passed
// through (-1: none).
static inline Hit traverse(const Scene* scene, Ray ray, float most, int anyHit, int ignored) {
  Hit hit;
  hit.distance = most;
  hit.primitive = -1;
  const float3 d = ray.direction;
  const float3 inverse =
      (float3)(1.0f / (fabs(d.x) > 1e-12f ? d.x : 1e-12f), 1.0f / (fabs(d.y) > 1e-12f ? d.y : 1e-12f),
               1.0f / (fabs(d.z) > 1e-12f ? d.z : 1e-12f));
  int stack[QUELL_BVH_STACK];
  float entries[QUELL_BVH_STACK];
  int height = 0;
  int current = 0;
  while (current >= 0) {
    __global const RenderBvhNode* node = scene->nodes + current;
    current = -1;
    if (node->count > 0) {
      for (int i = node->first; i < node->first + node->count; ++i) {
        const float distance = hitPrimitive(scene->primitives + i, ray, 0.0f);
        if (distance < hit.distance && (ignored < 0 || scene->primitives[i].light != ignored)) {
          hit.distance = distance;
          hit.primitive = i;
          if (anyHit) return hit;
        }
      }
    } else {
      int nearer = node->first, farther = node->first + 1;
      float entry = enterNode(scene->nodes + nearer, ray.origin, inverse, hit.distance);
      float other = enterNode(scene->nodes + farther, ray.origin, inverse, hit.distance);
      if (other < entry) {
        const int child = nearer;
        nearer = farther;
        farther = child;
        const float swapped = entry;
        entry = other;
        other = swapped;
      }
      if (other < INFINITY) {
        stack[height] = farther;
        entries[height++] = other;
      }
      if (entry < INFINITY) current = nearer;
    }
    while (current < 0 && height > 0)
      if (entries[--height] < hit.distance) current = stack[height];
  }
  return hit;
}

static inline Hit nearestHit(const Scene* scene, Ray ray) { return traverse(scene, ray, INFINITY, 0, -1); }

// 1 where nothing stands between the ray's origin and the point `distance` (m) along it, the light there aside: seen
// from the offset origin, its rim would hide itself.
static inline int isVisible(const Scene* scene, Ray ray, float distance, int light) {
  return traverse(scene, ray, distance, 1, light).primitive < 0;
}

#endif

// What a hit looks like: position, normals and material values.
#ifndef QUELL_RENDER_SURFACE_H
#define QUELL_RENDER_SURFACE_H

#include "render/sampling.h"
#include "render/textures.h"
#include "render/traverse.h"

// A shading normal keeps at least this cosine with the direction to the viewer.
#define QUELL_LEAST_VIEW_COSINE 0.02f
// Least roughness: keeps the density of GGX far from the range of a float.
#define QUELL_LEAST_ROUGHNESS 0.02f
// Step over which bumps are differentiated, per period of the texture.
#define QUELL_BUMP_STEP 0.02f

typedef struct Surface {
  float3 position;   // world, m
  float3 inObject;   // the same in object space
  float3 geometric;  // unit normals on the side of the viewer
  float3 normal;     // with bumps
  float3 albedo;
  float3 f0;
  float3 tint;
  float3 emission;
  float roughness;  // GGX alpha is its square
  int light;        // of the primitive, or -1
} Surface;

// Bends a shading normal until it faces the viewer.
static inline float3 faceViewer(float3 normal, float3 toViewer) {
  const float cosine = dot(normal, toViewer);
  if (cosine >= QUELL_LEAST_VIEW_COSINE) return normal;
  return normalize(normal + (QUELL_LEAST_VIEW_COSINE - cosine) * toViewer);
}

// Tilts n against the slope of the height texture (Blinn 1978, Simulation of Wrinkled Surfaces).
static inline float3 bumped(__global const RenderTexture* texture, int shape, float4 size, float3 p, float3 n,
                            float footprint) {
  if (texture->pattern == QUELL_PATTERN_CONSTANT) return n;
  float3 t, b;
  basisOf(n, &t, &b);
  const float step = fmax(QUELL_BUMP_STEP / texture->scale, 0.5f * footprint);
  const float here = textureAt(texture, shape, size, p, n, footprint);
  const float slopeT = (textureAt(texture, shape, size, p + step * t, n, footprint) - here) / step;
  const float slopeB = (textureAt(texture, shape, size, p + step * b, n, footprint) - here) / step;
  return normalize(n - slopeT * t - slopeB * b);
}

// `footprint`: width of the pixel on the surface (m). Bumps are left out (withBumps 0) where only light is gathered.
static inline Surface surfaceAt(const Scene* scene, Ray ray, Hit hit, float footprint, int withBumps) {
  __global const RenderPrimitive* primitive = scene->primitives + hit.primitive;
  __global const RenderMaterial* material = scene->materials + primitive->material;
  const int shape = primitive->shape;
  const float4 size = primitive->size;
  Surface surface;
  surface.position = ray.origin + hit.distance * ray.direction;
  const float3 p = pointToObject(primitive->toObject, surface.position);
  const float3 outward = shapeNormal(shape, size, p);
  const float3 normalWorld = directionToWorld(primitive->toObject, outward);
  const float side = dot(normalWorld, ray.direction) > 0.0f ? -1.0f : 1.0f;
  surface.inObject = p;
  surface.geometric = side * normalWorld;
  surface.normal = surface.geometric;
  if (withBumps) {
    const float3 tilted = bumped(&material->bumpTexture, shape, size, p, outward, footprint);
    surface.normal = faceViewer(side * directionToWorld(primitive->toObject, tilted), -ray.direction);
  }
  const float pattern = textureAt(&material->albedoTexture, shape, size, p, outward, footprint);
  const float metal = textureAt(&material->metalTexture, shape, size, p, outward, footprint);
  const float roughness = textureAt(&material->roughnessTexture, shape, size, p, outward, footprint);
  surface.albedo = (1.0f - metal) * mix(material->albedoA.xyz, material->albedoB.xyz, pattern);
  surface.f0 = mix(material->f0A.xyz, material->f0B.xyz, metal);
  surface.tint = material->tint.xyz;
  surface.roughness = fmax(roughness, QUELL_LEAST_ROUGHNESS);
  surface.light = primitive->light;
  // Emitting rectangles shine to one side.
  const int shines = shape != QUELL_SHAPE_RECTANGLE || side > 0.0f;
  surface.emission = shines ? material->emission.xyz : (float3)(0.0f);
  return surface;
}

static inline int isEmitter(const Surface* surface) { return surface->light >= 0; }

// A ray that leaves the surface on the side to which `direction` points.
static inline Ray leave(const Surface* surface, float3 direction) {
  const float side = dot(direction, surface->geometric) > 0.0f ? QUELL_RAY_OFFSET : -QUELL_RAY_OFFSET;
  Ray ray;
  ray.origin = surface->position + side * surface->geometric;
  ray.direction = direction;
  return ray;
}

#endif

// primary: one ray through the same place of every pixel; its feature buffers, free of noise, and the hit for `shade`.
// Paper:  Koskela et al. 2019, section 3 (the rasterised primary ray of their path tracer).
// Out:    packed float images of the components named below; 0 where the ray leaves the scene. Emitters have
//         emission, normal and position only. motion: previous pixel minus current pixel (px; x right, y down), for
//         the background that of a point at infinity. hits: primitive (or -1) and distance (m) as bits.
#include "render/camera.h"
#include "render/lights.h"
#include "render/surface.h"

static inline float2 motionOf(const RenderParams* params, __global const RenderPrimitive* primitive,
                              const Surface* surface) {
  const float2 size = (float2)((float)params->width, (float)params->height);
  const float3 before = pointToWorld(primitive->toObjectPrev, surface->inObject);
  const float3 now =
      pointToWorld(primitive->toObject, surface->inObject);  // rounded as `before` is: standing still gives 0
  return toPixel(&params->cameraPrev, before - params->cameraPrev.eye.xyz, 1.0f, size) -
         toPixel(&params->camera, now - params->camera.eye.xyz, 1.0f, size);
}

static inline float2 motionAtInfinity(const RenderParams* params, float3 direction) {
  const float2 size = (float2)((float)params->width, (float)params->height);
  return toPixel(&params->cameraPrev, direction, 0.0f, size) -
         toPixel(&params->camera, direction, 0.0f, size);
}

__kernel void primary(__global const RenderBvhNode* nodes, __global const RenderPrimitive* primitives,
                      __global const RenderMaterial* materials, __global const RenderLight* lights,
                      __global float* position, __global float* normal, __global float* albedo,
                      __global float* glossColor, __global float* f0, __global float* emission,
                      __global float* roughness, __global float* motion, __global int* objectId,
                      __global int* hits, RenderParams params) {
  const int x = (int)get_global_id(0);
  const int y = (int)get_global_id(1);
  if (x >= params.width || y >= params.height) return;
  const int pixel = y * params.width + x;
  Scene scene;
  scene.nodes = nodes;
  scene.primitives = primitives;
  scene.materials = materials;
  scene.lights = lights;
  const Ray ray = primaryRay(&params.camera, x, y);
  const Hit hit = nearestHit(&scene, ray);
  hits[2 * pixel] = hit.primitive;
  hits[2 * pixel + 1] = as_int(hit.distance);

  const float3 zero = (float3)(0.0f);
  if (hit.primitive < 0) {
    vstore3(zero, pixel, position);
    vstore3(zero, pixel, normal);
    vstore3(zero, pixel, albedo);
    vstore3(zero, pixel, glossColor);
    vstore3(zero, pixel, f0);
    vstore3(backgroundRadiance(&params.sky, ray.direction), pixel, emission);
    roughness[pixel] = 0.0f;
    vstore2(motionAtInfinity(&params, ray.direction), pixel, motion);
    objectId[pixel] = 0;
    return;
  }
  const Surface surface = surfaceAt(&scene, ray, hit, params.pixelAngle * hit.distance, 1);
  const int emitter = isEmitter(&surface);
  vstore3(surface.position, pixel, position);
  vstore3(surface.normal, pixel, normal);
  vstore3(emitter ? zero : surface.albedo, pixel, albedo);
  vstore3(emitter ? zero : surface.tint, pixel, glossColor);
  vstore3(emitter ? zero : surface.f0, pixel, f0);
  vstore3(surface.emission, pixel, emission);
  roughness[pixel] = emitter ? 0.0f : surface.roughness;
  vstore2(motionOf(&params, primitives + hit.primitive, &surface), pixel, motion);
  objectId[pixel] = primitives[hit.primitive].objectId;
}

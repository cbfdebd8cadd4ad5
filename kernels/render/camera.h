// Primary rays and projection.
#ifndef QUELL_RENDER_CAMERA_H
#define QUELL_RENDER_CAMERA_H

#include "render/shapes.h"

// The ray through the centre of pixel (x, y), (0, 0) at the top left.
static inline Ray primaryRay(const RenderCamera* camera, int x, int y) {
  Ray ray;
  ray.origin = camera->eye.xyz;
  ray.direction = normalize(camera->corner.xyz + (float)x * camera->stepX.xyz + (float)y * camera->stepY.xyz);
  return ray;
}

// Pixel coordinates of a point relative to the eye (w = 1), or of a direction (w = 0); x right, y down, (0.5, 0.5)
// is the centre of the first pixel.
static inline float2 toPixel(const RenderCamera* camera, float3 offset, float w, float2 size) {
  const float x = dot(camera->clip[0].xyz, offset) + w * camera->clip[0].w;
  const float y = dot(camera->clip[1].xyz, offset) + w * camera->clip[1].w;
  const float depth = dot(camera->clip[2].xyz, offset) + w * camera->clip[2].w;
  return (float2)(0.5f + 0.5f * x / depth, 0.5f - 0.5f * y / depth) * size;
}

#endif

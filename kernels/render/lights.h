// Lights: sampled for next-event estimation, and their densities for multiple importance sampling.
#ifndef QUELL_RENDER_LIGHTS_H
#define QUELL_RENDER_LIGHTS_H

#include "render/surface.h"

typedef struct LightSample {
  float3 direction;  // unit length
  float3 radiance;
  float distance;  // m
  float pdf;       // per solid angle, the choice of the light included; 0: no light from there
  int light;       // index
} LightSample;

// Sky: zenith and horizon mixed by height; below the horizon the ground.
static inline float3 skyRadiance(const RenderSky* sky, float3 direction) {
  if (direction.z < 0.0f)
    return mix(sky->horizon.xyz, sky->ground.xyz, clamp(-8.0f * direction.z, 0.0f, 1.0f));
  return mix(sky->horizon.xyz, sky->zenith.xyz, sqrt(direction.z));
}

static inline int isInSun(const RenderSky* sky, float3 direction) {
  return dot(direction, sky->sun.xyz) >= sky->sun.w;
}

// What a ray that leaves the scene sees.
static inline float3 backgroundRadiance(const RenderSky* sky, float3 direction) {
  return skyRadiance(sky, direction) + (isInSun(sky, direction) ? sky->sunRadiance.xyz : (float3)(0.0f));
}

// 1 - cosine of the angle at which a sphere is seen.
static inline float sphereVersine(float3 toCenter, float radius) {
  return oneMinusCosine(clamp(radius * radius / dot(toCenter, toCenter), 0.0f, 1.0f));
}

// Density per solid angle with which sampleLight() finds `direction`, `distance` being that of the light's surface.
static inline float lightPdf(__global const RenderLight* light, const Surface* from, float3 direction,
                             float distance) {
  switch (light->type) {
    case QUELL_LIGHT_RECTANGLE:
      return light->probability * distance * distance /
             (light->normal.w * fmax(-dot(light->normal.xyz, direction), 1e-6f));
    case QUELL_LIGHT_SPHERE:
      return light->probability * conePdf(sphereVersine(light->center.xyz - from->position, light->center.w));
    case QUELL_LIGHT_SUN:
      return light->probability * conePdf(1.0f - light->center.w);
    default:
      return light->probability * cosinePdf(dot(from->normal, direction));
  }
}

static inline LightSample sampleRectangle(__global const RenderLight* light, const Surface* from, float2 u) {
  LightSample sample;
  const float3 offset = light->center.xyz + (2.0f * u.x - 1.0f) * light->axisU.xyz +
                        (2.0f * u.y - 1.0f) * light->axisV.xyz - from->position;
  sample.distance = sqrt(dot(offset, offset));
  sample.direction = offset / sample.distance;
  sample.radiance = dot(light->normal.xyz, sample.direction) < 0.0f ? light->radiance.xyz : (float3)(0.0f);
  return sample;
}

static inline LightSample sampleSphere(__global const RenderLight* light, const Surface* from, float2 u) {
  LightSample sample;
  const float3 toCenter = light->center.xyz - from->position;
  const float radius = light->center.w;
  sample.direction = sampleCone(u, normalize(toCenter), sphereVersine(toCenter, radius));
  const float along = dot(toCenter, sample.direction);
  const float3 nearest = toCenter - along * sample.direction;
  sample.distance = along - sqrt(fmax(0.0f, radius * radius - dot(nearest, nearest)));
  sample.radiance = light->radiance.xyz;
  return sample;
}

static inline LightSample sampleDistant(__global const RenderLight* light, const RenderSky* sky,
                                        const Surface* from, float2 u) {
  LightSample sample;
  sample.distance = INFINITY;
  if (light->type == QUELL_LIGHT_SUN) {
    sample.direction = sampleCone(u, light->center.xyz, 1.0f - light->center.w);
    sample.radiance = light->radiance.xyz;
  } else {
    sample.direction = sampleCosine(u, from->normal);
    sample.radiance = skyRadiance(sky, sample.direction);
  }
  return sample;
}

// One point on one light, chosen by the lights' probabilities.
static inline LightSample sampleLight(const Scene* scene, const RenderParams* params, const Surface* from,
                                      Random* random) {
  float choice = nextUniform(random);
  const float2 u = nextUniform2(random);
  int index = 0;
  while (index < params->lightCount - 1 && choice >= scene->lights[index].probability)
    choice -= scene->lights[index++].probability;
  __global const RenderLight* light = scene->lights + index;
  LightSample sample;
  if (light->type == QUELL_LIGHT_RECTANGLE) {
    sample = sampleRectangle(light, from, u);
  } else if (light->type == QUELL_LIGHT_SPHERE) {
    sample = sampleSphere(light, from, u);
  } else {
    sample = sampleDistant(light, &params->sky, from, u);
  }
  sample.light = index;
  sample.pdf = lightPdf(light, from, sample.direction, sample.distance);
  if (dot(sample.radiance, sample.radiance) <= 0.0f || dot(sample.direction, from->geometric) <= 0.0f)
    sample.pdf = 0.0f;
  return sample;
}

#endif

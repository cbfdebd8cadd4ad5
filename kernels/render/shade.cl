// shade: light paths from the primary hits.
// Paper:  Koskela et al. 2019, section 3: next-event estimation, one secondary ray by importance sampling with multiple
//         importance sampling, a second shadow ray where it ends.
// In:     hits of `primary`. In and out: sums over samples of diffuse light (before albedo) and glossy light (before the
//         tint, Fresnel included), packed float3; the distance that the first secondary ray of the GGX lobe went (m;
//         QUELL_NO_HIT_DISTANCE: none yet, QUELL_MISS_DISTANCE: it left the scene).
// Departs: at the end of the secondary ray the GGX lobe is at least QUELL_INDIRECT_ROUGHNESS rough, since only a shadow ray
//         samples it there (path space regularisation, Kaplanyan and Dachsbacher 2013), and bumps are left out.
#include "render/bsdf.h"
#include "render/camera.h"
#include "render/lights.h"

#define QUELL_INDIRECT_ROUGHNESS 0.6f

// Weight of a sample whose technique has density `mine` where another has `other` (balance heuristic).
static inline float balance(float mine, float other) { return mine / (mine + other); }

static inline float lightWeight(int estimator, float lightPdf, float bsdfPdf) {
  if (estimator == QUELL_ESTIMATOR_BOTH) return balance(lightPdf, bsdfPdf);
  return estimator == QUELL_ESTIMATOR_LIGHT_ONLY ? 1.0f : 0.0f;
}

static inline float bsdfWeight(int estimator, float bsdfPdf, float lightPdf) {
  if (estimator == QUELL_ESTIMATOR_BOTH) return balance(bsdfPdf, lightPdf);
  return estimator == QUELL_ESTIMATOR_BSDF_ONLY ? 1.0f : 0.0f;
}

static inline void addScaled(Split* sum, Split value, float3 factor) {
  sum->diffuse += value.diffuse * factor;
  sum->glossy += value.glossy * factor;
}

// Next-event estimation at a primary hit.
static inline void addDirectLight(const Scene* scene, const RenderParams* params, const Surface* surface,
                                  const Bsdf* bsdf, Random* random, Split* sum) {
  const LightSample light = sampleLight(scene, params, surface, random);
  if (light.pdf <= 0.0f) return;
  float bsdfPdf;
  const Split value = evaluateBsdf(bsdf, light.direction, &bsdfPdf);
  const float weight = lightWeight(params->estimator, light.pdf, bsdfPdf);
  if (value.diffuse.x <= 0.0f || weight <= 0.0f) return;
  if (!isVisible(scene, leave(surface, light.direction), light.distance, light.light)) return;
  addScaled(sum, value, light.radiance * (weight / light.pdf));
}

// Radiance that the end of a secondary ray sends back by light that falls on it directly.
static inline float3 reflectedLight(const Scene* scene, const RenderParams* params, const Surface* surface,
                                    float3 toViewer, Random* random) {
  const Bsdf bsdf = makeBsdf(surface, toViewer, QUELL_INDIRECT_ROUGHNESS);
  const LightSample light = sampleLight(scene, params, surface, random);
  if (light.pdf <= 0.0f) return (float3)(0.0f);
  float unused;
  const Split value = evaluateBsdf(&bsdf, light.direction, &unused);
  const float3 reflected = surface->albedo * value.diffuse + surface->tint * value.glossy;
  if (luminance(reflected) <= 0.0f) return (float3)(0.0f);
  if (!isVisible(scene, leave(surface, light.direction), light.distance, light.light)) return (float3)(0.0f);
  return reflected * light.radiance / light.pdf;
}

// Sky and sun, each weighed against its own density.
static inline float3 escapedLight(const Scene* scene, const RenderParams* params, const Surface* from,
                                  float3 direction, float bsdfPdf) {
  float3 radiance = (float3)(0.0f);
  if (params->skyLight >= 0) {
    const float pdf = lightPdf(scene->lights + params->skyLight, from, direction, INFINITY);
    radiance += bsdfWeight(params->estimator, bsdfPdf, pdf) * skyRadiance(&params->sky, direction);
  }
  if (params->sunLight >= 0 && isInSun(&params->sky, direction)) {
    const float pdf = lightPdf(scene->lights + params->sunLight, from, direction, INFINITY);
    radiance += bsdfWeight(params->estimator, bsdfPdf, pdf) * params->sky.sunRadiance.xyz;
  }
  return radiance;
}

// Light along the secondary ray; *distance receives its length (m).
static inline float3 incomingLight(const Scene* scene, const RenderParams* params, const Surface* from,
                                   float3 direction, float bsdfPdf, Random* random, float* distance) {
  const Ray ray = leave(from, direction);
  const Hit hit = nearestHit(scene, ray);
  *distance = hit.primitive < 0 ? QUELL_MISS_DISTANCE : hit.distance;
  if (hit.primitive < 0) return escapedLight(scene, params, from, direction, bsdfPdf);
  const Surface surface = surfaceAt(scene, ray, hit, 0.0f, 0);
  if (!isEmitter(&surface)) return reflectedLight(scene, params, &surface, -direction, random);
  const float pdf = lightPdf(scene->lights + surface.light, from, direction, hit.distance);
  return bsdfWeight(params->estimator, bsdfPdf, pdf) * surface.emission;
}

// One sample of the light that a primary hit sends to the camera.
static inline Split samplePath(const Scene* scene, const RenderParams* params, const Surface* surface,
                               const Bsdf* bsdf, Random* random, float* hitDistance) {
  Split sum;
  sum.diffuse = (float3)(0.0f);
  sum.glossy = (float3)(0.0f);
  addDirectLight(scene, params, surface, bsdf, random, &sum);
  int glossy;
  const float3 direction = sampleBsdf(bsdf, random, &glossy);
  float pdf;
  const Split value = evaluateBsdf(bsdf, direction, &pdf);
  if (pdf <= 0.0f) return sum;
  float distance;
  const float3 light = incomingLight(scene, params, surface, direction, pdf, random, &distance);
  addScaled(&sum, value, light / pdf);
  if (glossy && *hitDistance == QUELL_NO_HIT_DISTANCE) *hitDistance = distance;
  return sum;
}

__kernel void shade(__global const RenderBvhNode* nodes, __global const RenderPrimitive* primitives,
                    __global const RenderMaterial* materials, __global const RenderLight* lights,
                    __global const int* hits, __global float* diffuseSum, __global float* glossySum,
                    __global float* hitDistances, RenderParams params) {
  const int x = (int)get_global_id(0);
  const int y = (int)get_global_id(1);
  if (x >= params.width || y >= params.height) return;
  const int pixel = y * params.width + x;
  Scene scene;
  scene.nodes = nodes;
  scene.primitives = primitives;
  scene.materials = materials;
  scene.lights = lights;
  Hit hit;
  hit.primitive = hits[2 * pixel];
  hit.distance = as_float(hits[2 * pixel + 1]);
  if (hit.primitive < 0 || params.lightCount == 0) return;
  const Ray ray = primaryRay(&params.camera, x, y);
  const Surface surface = surfaceAt(&scene, ray, hit, params.pixelAngle * hit.distance, 1);
  if (isEmitter(&surface)) return;
  const Bsdf bsdf = makeBsdf(&surface, -ray.direction, 0.0f);

  float3 diffuse = vload3(pixel, diffuseSum);
  float3 glossy = vload3(pixel, glossySum);
  float hitDistance = hitDistances[pixel];
  for (int i = 0; i < params.sampleCount; ++i) {
    Random random = randomFor(params.seed, (uint)pixel, (uint)(params.firstSample + i));
    const Split light = samplePath(&scene, &params, &surface, &bsdf, &random, &hitDistance);
    diffuse += light.diffuse;
    glossy += light.glossy;
  }
  vstore3(diffuse, pixel, diffuseSum);
  vstore3(glossy, pixel, glossySum);
  hitDistances[pixel] = hitDistance;
}

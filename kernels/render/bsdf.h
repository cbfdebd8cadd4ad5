// Diffuse lobe albedo / pi plus isotropic GGX with separable Smith masking and Schlick's Fresnel term.
//
// Values are split: `diffuse` is without albedo and `glossy` without the tint, both times the cosine; so that
// color = albedo diffuse + tint glossy.
#ifndef QUELL_RENDER_BSDF_H
#define QUELL_RENDER_BSDF_H

#include "render/surface.h"

// Either lobe of a material with both gets at least this share of the secondary rays.
#define QUELL_LEAST_LOBE_PROBABILITY 0.25f

typedef struct Bsdf {
  float3 normal;
  float3 geometric;
  float3 toViewer;
  float3 f0;
  float alpha;
  float glossyProbability;  // of a secondary ray
} Bsdf;

typedef struct Split {
  float3 diffuse;
  float3 glossy;
} Split;

static inline float luminance(float3 c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }  // Rec. 709

// Schlick 1994; F0 = 1 gives 1.
static inline float3 fresnel(float3 f0, float cosine) {
  const float m = clamp(1.0f - cosine, 0.0f, 1.0f);
  const float m2 = m * m;
  return f0 + (1.0f - f0) * (m2 * m2 * m);
}

// Walter et al. 2007, eq. (33), isotropic GGX; cosine: of the half vector with the normal.
static inline float ggxDistribution(float cosine, float alpha) {
  const float a2 = alpha * alpha;
  const float d = (a2 - 1.0f) * cosine * cosine + 1.0f;
  return a2 / (QUELL_PI * d * d);
}

// Walter et al. 2007, eq. (34).
static inline float smithMasking(float cosine, float alpha) {
  const float a2 = alpha * alpha;
  return 2.0f * cosine / (cosine + sqrt(a2 + (1.0f - a2) * cosine * cosine));
}

static inline Bsdf makeBsdf(const Surface* surface, float3 toViewer, float leastRoughness) {
  Bsdf bsdf;
  const float roughness = fmax(surface->roughness, leastRoughness);
  bsdf.normal = surface->normal;
  bsdf.geometric = surface->geometric;
  bsdf.toViewer = toViewer;
  bsdf.f0 = surface->f0;
  bsdf.alpha = roughness * roughness;
  const float glossy = luminance(surface->tint * fresnel(surface->f0, dot(surface->normal, toViewer)));
  const float diffuse = luminance(surface->albedo);
  const float share = glossy / fmax(glossy + diffuse, 1e-12f);
  bsdf.glossyProbability = clamp(share, QUELL_LEAST_LOBE_PROBABILITY, 1.0f - QUELL_LEAST_LOBE_PROBABILITY);
  if (glossy <= 0.0f) bsdf.glossyProbability = 0.0f;
  if (diffuse <= 0.0f) bsdf.glossyProbability = 1.0f;
  return bsdf;
}

// Both lobes times the cosine for light from `direction`, and in *pdf the density with which sampleBsdf() finds it.
static inline Split evaluateBsdf(const Bsdf* bsdf, float3 direction, float* pdf) {
  Split value;
  value.diffuse = (float3)(0.0f);
  value.glossy = (float3)(0.0f);
  *pdf = 0.0f;
  const float cosIn = dot(bsdf->normal, direction);
  const float cosOut = dot(bsdf->normal, bsdf->toViewer);
  if (cosIn <= 0.0f || cosOut <= 0.0f || dot(bsdf->geometric, direction) <= 0.0f) return value;
  value.diffuse = (float3)(cosIn / QUELL_PI);
  *pdf = (1.0f - bsdf->glossyProbability) * cosinePdf(cosIn);
  if (bsdf->glossyProbability <= 0.0f) return value;
  const float3 halfway = normalize(direction + bsdf->toViewer);
  const float density = ggxDistribution(dot(bsdf->normal, halfway), bsdf->alpha);
  const float maskOut = smithMasking(cosOut, bsdf->alpha);
  const float perView =
      density * maskOut / (4.0f * cosOut);  // Heitz 2018, eq. (3) and (17): D_visible / (4 o.h)
  value.glossy = fresnel(bsdf->f0, dot(halfway, direction)) * (perView * smithMasking(cosIn, bsdf->alpha));
  *pdf += bsdf->glossyProbability * perView;
  return value;
}

// A normal of the microfacets that `view` sees; z is the surface's normal. Heitz 2018, Sampling the GGX Distribution of
// Visible Normals, listing 1.
static inline float3 sampleVisibleNormal(float3 view, float alpha, float2 u) {
  const float3 stretched = normalize((float3)(alpha * view.x, alpha * view.y, view.z));
  const float length2 = stretched.x * stretched.x + stretched.y * stretched.y;
  const float3 t1 =
      length2 > 0.0f ? (float3)(-stretched.y, stretched.x, 0.0f) / sqrt(length2) : (float3)(1.0f, 0.0f, 0.0f);
  const float3 t2 = cross(stretched, t1);
  const float radius = sqrt(u.x);
  const float angle = 2.0f * QUELL_PI * u.y;
  const float p1 = radius * cos(angle);
  const float s = 0.5f * (1.0f + stretched.z);
  const float p2 = (1.0f - s) * sqrt(fmax(0.0f, 1.0f - p1 * p1)) + s * radius * sin(angle);
  const float3 n = p1 * t1 + p2 * t2 + sqrt(fmax(0.0f, 1.0f - p1 * p1 - p2 * p2)) * stretched;
  return normalize((float3)(alpha * n.x, alpha * n.y, fmax(0.0f, n.z)));
}

// A direction for the secondary ray; *glossy tells which lobe chose it. It may point below the surface, where
// evaluateBsdf() gives zero.
static inline float3 sampleBsdf(const Bsdf* bsdf, Random* random, int* glossy) {
  const float choice = nextUniform(random);
  const float2 u = nextUniform2(random);
  *glossy = choice < bsdf->glossyProbability;
  if (!*glossy) return sampleCosine(u, bsdf->normal);
  float3 t, b;
  basisOf(bsdf->normal, &t, &b);
  const float3 view =
      (float3)(dot(bsdf->toViewer, t), dot(bsdf->toViewer, b), dot(bsdf->toViewer, bsdf->normal));
  const float3 m = sampleVisibleNormal(view, bsdf->alpha, u);
  const float3 halfway = m.x * t + m.y * b + m.z * bsdf->normal;
  return normalize(2.0f * dot(bsdf->toViewer, halfway) * halfway - bsdf->toViewer);
}

#endif

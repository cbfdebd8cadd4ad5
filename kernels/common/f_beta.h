// F_beta, the BRDF integrated over all incident directions, looked up: F_beta = F0 * scale + bias.
//
// Zhuang et al. 2021, eq. (7) and section 4.1, for isotropic GGX with Schlick's Fresnel; kernels/f_beta_table.cl fills
// the table. roughness is the perceptual one throughout: alpha = roughness^2.
#ifndef QUELL_COMMON_F_BETA_H
#define QUELL_COMMON_F_BETA_H

#include "common/lanes.h"
#include "f_beta_table_params.h"

typedef struct FBeta {
  floatL scale;  // what F0 is multiplied with, 0 to 1
  floatL bias;   // what is reflected even if F0 is 0, 0 to 1
} FBeta;

// (1 - cosTheta)^5, the share of Schlick's Fresnel term that does not depend on F0. cosTheta is clamped to [.., 1].
QUELL_INLINE floatL schlickWeight(floatL cosTheta) {
  const floatL m = maxLanes(1.0f - cosTheta, ZERO_LANES);
  const floatL m2 = m * m;
  return m2 * m2 * m;
}

// Bilinear between texels. cosTheta is that of view direction and normal, roughness in [0, 1]; both are clamped, a NaN
// counts as cosTheta 0 and as roughness 1, so the result is always finite.
// Error of the interpolation, largest: 2e-4 for cosTheta >= 0.02; up to 0.03 below 0.001 with roughness below 0.1.
QUELL_INLINE FBeta lookUpFBeta(__global const float4* table, floatL cosTheta, floatL roughness) {
  const float last = (float)(QUELL_F_BETA_EDGE - 1);
  const floatL u = SQRT(clampLanes(cosTheta, 0.0f, 1.0f)) * last;
  const floatL v = maxLanes(minLanes(roughness, ONE_LANES), ZERO_LANES) * last;
  const intL x = minLanesInt(TO_INT(u), (intL)(QUELL_F_BETA_EDGE - 2));
  const intL y = minLanesInt(TO_INT(v), (intL)(QUELL_F_BETA_EDGE - 2));
  const floatL fx = u - TO_FLOAT(x);
  const floatL fy = v - TO_FLOAT(y);
  const intL entry = y * QUELL_F_BETA_EDGE + x;
  FBeta result;
#if QUELL_LANES == 1
  const float4 low = table[entry];
  const float4 row = low + (table[entry + QUELL_F_BETA_EDGE] - low) * fy;
  result.scale = row.x + (row.z - row.x) * fx;
  result.bias = row.y + (row.w - row.y) * fx;
#else
  float scale[QUELL_LANES], bias[QUELL_LANES];
  for (int lane = 0; lane < QUELL_LANES; ++lane) {
    const int i = ((const int*)&entry)[lane];
    const float4 low = table[i];
    const float4 row = low + (table[i + QUELL_F_BETA_EDGE] - low) * ((const float*)&fy)[lane];
    const float2 texel = row.xy + (row.zw - row.xy) * ((const float*)&fx)[lane];
    scale[lane] = texel.x;
    bias[lane] = texel.y;
  }
  result.scale = LOAD_VECTOR(scale);
  result.bias = LOAD_VECTOR(bias);
#endif
  return result;
}

// F_beta of three channels. f0 in [0, 1] gives [0, 1].
QUELL_INLINE float3L fBeta3(FBeta terms, float3L f0) {
  f0.x = f0.x * terms.scale + terms.bias;
  f0.y = f0.y * terms.scale + terms.bias;
  f0.z = f0.z * terms.scale + terms.bias;
  return f0;
}

// |cos| of the angle between two vectors of any length whose squares neither overflow nor vanish (1e-18 to 1e18); 0 if
// one of them is 0, 0 or NaN if one is not finite.
QUELL_INLINE floatL absCosine(float3L a, float3L b) {
  const floatL lengthSquared = dot3(a, a) * dot3(b, b);
  const floatL cosine = absLanes(dot3(a, b)) / SQRT(lengthSquared);
  return lengthSquared > 0.0f ? cosine : ZERO_LANES;
}

// F_beta of what a pixel shows; times the gloss colour it is the factor of the glossy signal (Zhuang et al. 2021,
// eq. (8)). Takes the camera-relative position (or any vector along the view ray, as an orthographic camera needs it),
// the shading normal (both sides of a surface are alike), roughness in [0, 1] and F0 in [0, 1] (1 if not known).
// In [0, 1] and finite if F0 is, see lookUpFBeta() for broken inputs.
QUELL_INLINE float3L surfaceFBeta3(__global const float4* table, float3L position, float3L normal,
                                   floatL roughness, float3L f0) {
  return fBeta3(lookUpFBeta(table, absCosine(position, normal), roughness), f0);
}

#endif

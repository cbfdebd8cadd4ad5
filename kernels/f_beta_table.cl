// f_beta_table: the BRDF integrated over all incident directions, for every view angle and roughness. Runs once.
// Paper:   Zhuang et al. 2021, eq. (7), tabulated as in section 4.1: F_beta(wo) = int fr(wi, wo) cos(theta_i) dwi.
//          Departures: the BRDF is divided by 4 cos(theta_i) cos(theta_o), as its reciprocity and the literature want
//          it (eq. (4) prints other cosines); the two terms of Schlick's Fresnel are kept apart, so that one table
//          serves every F0; the axis of cos(theta_o) has quadratic steps.
// BRDF:    isotropic GGX, alpha = roughness^2; Smith masking-shadowing, G1(o) G1(i), or height-correlated with
//          F_BETA_CORRELATED; Schlick's F = F0 + (1 - F0) (1 - h.o)^5. So F_beta = F0 * scale + bias.
// In:      samples (t, cos(phi), sin(phi)^2, weight), QUELL_F_BETA_SAMPLES of them, weights summing to 1.
// Out:     the table, laid out as f_beta_table_params.h says; scale and bias in [0, 1], their sum at most 1.
// Method:  half vectors of the distribution of visible normals (Heitz 2018): the estimator is F G2(o, i) / G1(o), which
//          is bounded and smooth but for a kink where wi meets the horizon. They are drawn as sums of the view
//          direction and a point on a spherical cap, both in the space where the surface has alpha = 1 (Dupuy and
//          Benyoub 2023). The same lattice serves every texel; t, the height on the cap, has quadratic steps, since low
//          alphas crowd the horizon into small t.
// Error:   largest against a double-precision quadrature: 1e-4, see tests/stages/f_beta_table_test.cpp.
#include "common/f_beta.h"

// The view direction of a texel, on the surface and in the space where the surface has alpha = 1.
typedef struct View {
  floatL cosTheta, sinTheta;
  floatL root;  // sqrt(alpha^2 sin^2 + cos^2): length after stretching, and the root in Smith's G1
  floatL stretchedX, stretchedZ;
} View;

QUELL_INLINE View makeView(floatL cosTheta, float alpha) {
  View view;
  view.cosTheta = cosTheta;
  view.sinTheta = SQRT((1.0f - cosTheta) * (1.0f + cosTheta));
  view.root = SQRT(alpha * alpha + (1.0f - alpha * alpha) * cosTheta * cosTheta);
  view.stretchedX = alpha * view.sinTheta / view.root;
  view.stretchedZ = cosTheta / view.root;
  return view;
}

// G2(o, i) / G1(o); 0 for directions below the horizon.
QUELL_INLINE floatL shadowing(View view, floatL cosIncident, float alpha) {
  const floatL root = SQRT(alpha * alpha + (1.0f - alpha * alpha) * cosIncident * cosIncident);
#if F_BETA_CORRELATED
  const floatL ratio =
      cosIncident * (view.cosTheta + view.root) / (view.cosTheta * root + cosIncident * view.root);
#else
  const floatL ratio = 2.0f * cosIncident / (cosIncident + root);
#endif
  return cosIncident > 0.0f ? ratio : ZERO_LANES;
}

QUELL_INLINE FBeta addSample(FBeta sum, float4 sample, View view, float alpha) {
  // Cap of heights z in [-stretchedZ, 1]; its point plus the view direction, stretched back, is along the half vector.
  const floatL capHeight = 1.0f + view.stretchedZ;
  const floatL z = capHeight * sample.x - view.stretchedZ;
  const floatL radiusSquared = maxLanes(capHeight * (1.0f - sample.x) * (1.0f + z), ZERO_LANES);
  const floatL along = SQRT(radiusSquared) * sample.y + view.stretchedX;
  const floatL hx = alpha * along;
  const floatL hz = z + view.stretchedZ;
  const floatL lengthSquared = alpha * alpha * (along * along + radiusSquared * sample.z) + hz * hz;
  const floatL inverseLength = 1.0f / SQRT(lengthSquared);
  const floatL cosHalf = (view.sinTheta * hx + view.cosTheta * hz) * inverseLength;
  const floatL cosIncident = 2.0f * cosHalf * hz * inverseLength - view.cosTheta;
  const floatL weight = sample.w * shadowing(view, cosIncident, alpha);
  const floatL schlick = schlickWeight(cosHalf);
  sum.scale += weight * (1.0f - schlick);
  sum.bias += weight * schlick;
  return sum;
}

// A perfect mirror reflects the Fresnel term of the one direction.
QUELL_INLINE FBeta mirrorFBeta(floatL cosTheta) {
  FBeta result;
  result.bias = schlickWeight(cosTheta);
  result.scale = 1.0f - result.bias;
  return result;
}

QUELL_INLINE void storeTexel(__global float2* table, int x, int y, float2 texel) {
  const int entry = y * QUELL_F_BETA_EDGE + x;
  table[2 * entry] = texel;
  if (x > 0) table[2 * entry - 1] = texel;
  if (x == QUELL_F_BETA_EDGE - 1) table[2 * entry + 1] = texel;
}

__kernel void f_beta_table(__global const float4* samples, __global float2* table) {
  const int x = (int)get_global_id(0) * QUELL_LANES;
  const int y = (int)get_global_id(1);
  if (x >= QUELL_F_BETA_EDGE || y >= QUELL_F_BETA_EDGE) return;
  const floatL rootCos = TO_FLOAT((intL)(x) + LANE_INDEX) / (float)(QUELL_F_BETA_EDGE - 1);
  const floatL cosTheta = rootCos * rootCos;
  const float roughness = (float)y / (float)(QUELL_F_BETA_EDGE - 1);
  const float alpha = roughness * roughness;

  FBeta result;
  if (y == 0) {
    result = mirrorFBeta(cosTheta);
  } else {
    const View view = makeView(cosTheta, alpha);
    result.scale = ZERO_LANES;
    result.bias = ZERO_LANES;
    for (int i = 0; i < QUELL_F_BETA_SAMPLES; ++i) result = addSample(result, samples[i], view, alpha);
  }
  const float* scales = (const float*)&result.scale;
  const float* biases = (const float*)&result.bias;
  for (int lane = 0; lane < QUELL_LANES; ++lane)
    storeTexel(table, x + lane, y, (float2)(scales[lane], biases[lane]));
}

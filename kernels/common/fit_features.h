// The features of a pixel, and a fit evaluated with them, as every stage of a fit sees them.
//
// The host writes the lists that are expanded here from the setting `features` (host/stages/fit_features.cpp):
// QUELL_SCALED_LIST is a row of SCALED(k, variable), QUELL_FEATURE_LIST a row of FEATURE(k, product), in the names that
// are defined below. What is not named is not loaded.
#ifndef QUELL_COMMON_FIT_FEATURES_H
#define QUELL_COMMON_FIT_FEATURES_H

#include "common/blocks.h"
#include "common/guides.h"
#include "common/planes.h"
#include "fit_params.h"

#ifndef QUELL_SCALED_LIST
#define QUELL_SCALED_LIST
#endif
#ifndef QUELL_FEATURE_LIST
#define QUELL_FEATURE_LIST
#endif

// What features are made of.
typedef struct Guide {
  float3L position;  // relative to the camera, scene units
  float3L normal;    // world space
#if QUELL_USES_PIXEL
  floatL column;
  floatL row;
#endif
#if QUELL_USES_MATERIAL
  float3L albedo;    // 0 to 1
  floatL roughness;  // 0 to 1
#endif
} Guide;

#define PX (guide.position.x)
#define PY (guide.position.y)
#define PZ (guide.position.z)
#define NX (guide.normal.x)
#define NY (guide.normal.y)
#define NZ (guide.normal.z)
#define DEPTH (viewAxis.x * PX + viewAxis.y * PY + viewAxis.z * PZ)
#define COLUMN (guide.column)
#define ROW (guide.row)
#define AR (guide.albedo.x)
#define AG (guide.albedo.y)
#define AB (guide.albedo.z)
#define ROUGHNESS (guide.roughness)
#define ROOT(v) SQRT(absLanes(v))
// Scaled variable k.
#define S(k) (scaled[k])

QUELL_INLINE Guide gatherGuide(__global const float* guides, __global const float* materials,
                               PlaneParams planes, GatherPlan plan) {
  const int stride = planes.stride;
  Guide guide;
  guide.position = gatherLanes3(guides + QUELL_GUIDE_POSITION * stride, plan, stride);
  guide.normal = gatherLanes3(guides + QUELL_GUIDE_NORMAL * stride, plan, stride);
#if QUELL_USES_PIXEL
  // A mirrored pixel keeps the place that it comes from, as its other features do.
  const intL line = plan.index / planes.pitch;
  guide.column = TO_FLOAT(plan.index - line * planes.pitch - QUELL_PLANE_MARGIN);
  guide.row = TO_FLOAT(line - QUELL_PLANE_MARGIN_ROWS);
#endif
#if QUELL_USES_MATERIAL
  guide.albedo = gatherLanes3(materials + QUELL_MATERIAL_ALBEDO * stride, plan, stride);
  guide.roughness = gatherLanes(materials + QUELL_MATERIAL_ROUGHNESS * stride, plan);
#endif
  return guide;
}

// The variables that are scaled, as they are.
QUELL_INLINE void makeScaled(floatL* scaled, Guide guide, float4 viewAxis) {
#define SCALED(k, value) scaled[k] = value;
  QUELL_SCALED_LIST
#undef SCALED
}

// The products that are features; the lists are written out, since loops over them would be left rolled.
QUELL_INLINE void multiplyFeatures(floatL* features, Guide guide, const floatL* scaled) {
  features[0] = ONE_LANES;
#define FEATURE(k, value) features[k] = value;
  QUELL_FEATURE_LIST
#undef FEATURE
}

// All features of a pixel.
QUELL_INLINE void makeFeatures(floatL* features, Guide guide, float4 viewAxis, const float* anchor,
                               const float* scale) {
  floatL scaled[QUELL_SCALED_SLOTS];
#define SCALED(k, value) scaled[k] = ((value)-anchor[k]) * scale[k];
  QUELL_SCALED_LIST
#undef SCALED
  multiplyFeatures(features, guide, scaled);
}

// A record's fit at a pixel, for all channels.
QUELL_INLINE float3L evaluateFit(__global const float* record, Guide guide, float4 viewAxis) {
  floatL scaled[QUELL_SCALED_SLOTS];
#define SCALED(k, value) scaled[k] = ((value)-record[QUELL_FIT_ANCHOR + (k)]) * record[QUELL_FIT_SCALE + (k)];
  QUELL_SCALED_LIST
#undef SCALED
  floatL features[QUELL_FEATURES];
  multiplyFeatures(features, guide, scaled);
  float3L sum = splat3(0.0f);
  for (int j = 0; j < QUELL_FEATURES; ++j) {
    sum.x += features[j] * record[j * QUELL_FIT_CHANNELS];
    sum.y += features[j] * record[j * QUELL_FIT_CHANNELS + 1];
    sum.z += features[j] * record[j * QUELL_FIT_CHANNELS + 2];
  }
  return sum;
}

#endif

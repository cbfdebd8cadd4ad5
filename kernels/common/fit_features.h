// The feature vector of one pixel, and a fit evaluated with it, as every stage of a fit sees them.
#ifndef QUELL_COMMON_FIT_FEATURES_H
#define QUELL_COMMON_FIT_FEATURES_H

#include "common/lanes.h"
#include "fit_params.h"

QUELL_INLINE void makeFeatures(floatL features[QUELL_FEATURES], float3L normal, float3L scaledPosition) {
  features[0] = ONE_LANES;
  features[1] = normal.x;
  features[2] = normal.y;
  features[3] = normal.z;
  features[4] = scaledPosition.x;
  features[5] = scaledPosition.y;
  features[6] = scaledPosition.z;
  features[7] = scaledPosition.x * scaledPosition.x;
  features[8] = scaledPosition.y * scaledPosition.y;
  features[9] = scaledPosition.z * scaledPosition.z;
}

// A record's fit at a camera-relative position, for all channels.
QUELL_INLINE float3L evaluateFit(__global const float* record, float3L position, float3L normal) {
  position.x = (position.x - record[QUELL_FIT_ANCHOR]) * record[QUELL_FIT_SCALE];
  position.y = (position.y - record[QUELL_FIT_ANCHOR + 1]) * record[QUELL_FIT_SCALE + 1];
  position.z = (position.z - record[QUELL_FIT_ANCHOR + 2]) * record[QUELL_FIT_SCALE + 2];
  floatL features[QUELL_FEATURES];
  makeFeatures(features, normal, position);
  float3L sum = splat3(0.0f);
  for (int j = 0; j < QUELL_FEATURES; ++j) {
    sum.x += features[j] * record[j * QUELL_FIT_CHANNELS];
    sum.y += features[j] * record[j * QUELL_FIT_CHANNELS + 1];
    sum.z += features[j] * record[j * QUELL_FIT_CHANNELS + 2];
  }
  return sum;
}

#endif

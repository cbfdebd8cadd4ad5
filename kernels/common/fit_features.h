// The feature vector of one pixel, as fit and weighted_sum both see it.
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

#endif

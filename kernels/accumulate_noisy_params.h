// Parameters of the stage accumulate_noisy.
#ifndef QUELL_ACCUMULATE_NOISY_PARAMS_H
#define QUELL_ACCUMULATE_NOISY_PARAMS_H

#include "common/reprojection_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct AccumulateNoisyParams {
  ReprojectionParams reprojection;
  PlaneParams planes;
  ImageViewParams radiance;
  ImageViewParams emission;
  ImageViewParams albedo;
  ImageViewParams glossColor;
  ImageViewParams normal;
  ImageViewParams position;
  QuellFloat leastWeight;  // least weight of the newest sample, (0, 1]
} AccumulateNoisyParams;

QUELL_NAMESPACE_END

// The history length is stored in a byte (paper, phase I: "8-bit integers").
#define QUELL_MAX_HISTORY_LENGTH 255

// Planes of the guides kept for the next frame and for the fit.
#define QUELL_GUIDE_POSITION 0  // camera-relative position, 3 planes
#define QUELL_GUIDE_NORMAL 3    // world-space normal, 3 planes; 0 where the pixel cannot be filtered
#define QUELL_GUIDE_WEIGHT 6    // weight as a filter tap, 0 to 1; 0 where there is no sample
#define QUELL_GUIDE_PLANES 7

// Bits of the reprojection mask.
#define QUELL_TAP_ACCEPTED(i) (1 << (i))  // bilinear tap i shows the same surface
#define QUELL_PREV_IN_FRAME 16            // the pixel lay inside the frame before

#endif

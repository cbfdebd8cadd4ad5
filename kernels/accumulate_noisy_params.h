// Parameters of the stage accumulate_noisy.
#ifndef QUELL_ACCUMULATE_NOISY_PARAMS_H
#define QUELL_ACCUMULATE_NOISY_PARAMS_H

#include "common/guides.h"
#include "common/innovation.h"
#include "common/material_params.h"
#include "common/motion_params.h"
#include "common/reprojection_params.h"
#include "common/surface_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct AccumulateNoisyParams {
  ReprojectionParams reprojection;
  PlaneParams planes;
  MaterialParams material;
  SurfaceParams surface;
  MotionParams motion;
  QuellFloat leastWeight;         // least weight of the newest sample, (0, 1]
  QuellFloat momentsLeastWeight;  // the same for the moments of luminance
  QuellInt mostFrames;            // longest history, frames, 1 to QUELL_MAX_HISTORY_LENGTH
  QuellInt mostFramesStill;       // the same of pixels that lie where they lay in the frame before
  QuellInt jitters;  // whether this frame or the one before is sampled off the pixel centres; only with SKIP
} AccumulateNoisyParams;

QUELL_NAMESPACE_END

#endif

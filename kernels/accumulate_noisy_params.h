// Parameters of the stage accumulate_noisy.
#ifndef QUELL_ACCUMULATE_NOISY_PARAMS_H
#define QUELL_ACCUMULATE_NOISY_PARAMS_H

#include "common/frame_image_params.h"
#include "common/guides.h"
#include "common/innovation.h"
#include "common/reprojection_params.h"

QUELL_NAMESPACE_BEGIN

typedef struct AccumulateNoisyParams {
  ReprojectionParams reprojection;
  PlaneParams planes;
  FrameImageParams images;
  QuellFloat leastWeight;         // least weight of the newest sample, (0, 1]
  QuellFloat momentsLeastWeight;  // the same for the moments of luminance
  QuellInt mostFrames;            // longest history, frames, 1 to QUELL_MAX_HISTORY_LENGTH
  QuellInt mostFramesStill;       // the same of pixels that lie where they lay in the frame before
  QuellInt antialiasBackground;   // whether background takes part in temporal_antialiasing; only with SKIP
} AccumulateNoisyParams;

QUELL_NAMESPACE_END

#endif

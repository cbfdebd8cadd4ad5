// Parameters of the stage background.
#ifndef QUELL_BACKGROUND_PARAMS_H
#define QUELL_BACKGROUND_PARAMS_H

#include "common/frame_image_params.h"

QUELL_NAMESPACE_BEGIN

typedef struct BackgroundParams {
  PlaneParams planes;
  FrameImageParams images;
  OutputImageParams outputs;
  QuellFloat exposure;  // factor of radiance in the display image
  QuellInt finish;      // whether the display image is written as well; if not, temporal_antialiasing does it
} BackgroundParams;

QUELL_NAMESPACE_END

#endif

// Parameters of the stage demodulate.
#ifndef QUELL_DEMODULATE_PARAMS_H
#define QUELL_DEMODULATE_PARAMS_H

#include "common/frame_image_params.h"
#include "common/reprojection_params.h"

QUELL_NAMESPACE_BEGIN

typedef struct DemodulateParams {
  ReprojectionParams reprojection;
  PlaneParams planes;
  FrameImageParams images;
} DemodulateParams;

QUELL_NAMESPACE_END

#endif

// Parameters of the stage background.
#ifndef QUELL_BACKGROUND_PARAMS_H
#define QUELL_BACKGROUND_PARAMS_H

#include "common/material_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct BackgroundParams {
  PlaneParams planes;
  MaterialParams material;
  ImageViewParams linearOutput;
  ImageViewParams displayOutput;
  QuellInt finish;  // whether the display image is written as well; if not, temporal_antialiasing does it
} BackgroundParams;

QUELL_NAMESPACE_END

#endif

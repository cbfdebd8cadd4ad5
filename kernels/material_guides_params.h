// Parameters of the stage material_guides.
#ifndef QUELL_MATERIAL_GUIDES_PARAMS_H
#define QUELL_MATERIAL_GUIDES_PARAMS_H

#include "common/frame_image_params.h"

QUELL_NAMESPACE_BEGIN

typedef struct MaterialGuidesParams {
  PlaneParams planes;
  FrameImageParams images;
} MaterialGuidesParams;

QUELL_NAMESPACE_END

#endif

// Parameters of the stage tone_map.
#ifndef QUELL_TONE_MAP_PARAMS_H
#define QUELL_TONE_MAP_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct ToneMapParams {
  PlaneParams planes;
  ImageViewParams output;
} ToneMapParams;

QUELL_NAMESPACE_END

#endif

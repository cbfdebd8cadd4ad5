// Parameters of the stage remodulate.
#ifndef QUELL_REMODULATE_PARAMS_H
#define QUELL_REMODULATE_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct RemodulateParams {
  PlaneParams planes;
  ImageViewParams radiance;
  ImageViewParams emission;
  ImageViewParams albedo;
  ImageViewParams glossColor;
  ImageViewParams output;
} RemodulateParams;

QUELL_NAMESPACE_END

#endif

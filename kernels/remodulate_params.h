// Parameters of the stage remodulate.
#ifndef QUELL_REMODULATE_PARAMS_H
#define QUELL_REMODULATE_PARAMS_H

#include "common/material_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct RemodulateParams {
  PlaneParams planes;
  MaterialParams material;
  ImageViewParams linearOutput;
  ImageViewParams displayOutput;
} RemodulateParams;

QUELL_NAMESPACE_END

#endif

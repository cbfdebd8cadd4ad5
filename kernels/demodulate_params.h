// Parameters of the stage demodulate.
#ifndef QUELL_DEMODULATE_PARAMS_H
#define QUELL_DEMODULATE_PARAMS_H

#include "common/guides.h"
#include "common/material_params.h"
#include "common/reprojection_params.h"
#include "common/surface_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct DemodulateParams {
  ReprojectionParams reprojection;
  PlaneParams planes;
  MaterialParams material;
  SurfaceParams surface;
} DemodulateParams;

QUELL_NAMESPACE_END

#endif

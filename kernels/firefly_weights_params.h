// Parameters of the stage firefly_weights.
#ifndef QUELL_FIREFLY_WEIGHTS_PARAMS_H
#define QUELL_FIREFLY_WEIGHTS_PARAMS_H

#include "common/fireflies_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct FireflyWeightsParams {
  PlaneParams planes;
  QuellFloat fireflyRatio;  // times as bright as the brightest around: a firefly; > 0
} FireflyWeightsParams;

QUELL_NAMESPACE_END

#endif

// Parameters of the stage variance.
#ifndef QUELL_VARIANCE_PARAMS_H
#define QUELL_VARIANCE_PARAMS_H

#include "common/edge_stops_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct VarianceParams {
  PlaneParams planes;
  EdgeStopParams stops;
  QuellInt temporalFrames;  // history length from which on the variance over time is trusted
} VarianceParams;

QUELL_NAMESPACE_END

// Half of the edge of the spatial estimate's window, pixels (Flatval 2020, ch. 3.2.2 after Schied et al. 2017: 7x7).
#define QUELL_VARIANCE_RADIUS 3

#endif

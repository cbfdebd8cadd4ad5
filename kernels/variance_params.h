// Parameters of the stage variance.
#ifndef QUELL_VARIANCE_PARAMS_H
#define QUELL_VARIANCE_PARAMS_H

#include "common/edge_stops_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct VarianceParams {
  PlaneParams planes;
  EdgeStopParams stops;
  QuellFloat fireflyRatio;   // of a firefly's luminance to that of the brightest pixel around, > 0
  QuellFloat momentsFrames;  // samples that moments are worth at most: 1 / least weight of the newest
  QuellInt temporalFrames;   // history length from which on the variance over time is trusted
} VarianceParams;

QUELL_NAMESPACE_END

// Half of the edge of the spatial estimate's window, pixels (Flatval 2020, ch. 3.2.2 after Schied et al. 2017: 7x7).
#define QUELL_VARIANCE_RADIUS 3

// The second moment of n samples is n times the squared first if one of them has all the light. So much of that is enough.
#define QUELL_FIREFLY_SHARE_OF_SAMPLES 0.7f

#endif

// Parameters of the stage separable_bilateral.
#ifndef QUELL_SEPARABLE_BILATERAL_PARAMS_H
#define QUELL_SEPARABLE_BILATERAL_PARAMS_H

#include "common/edge_stops_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct SeparableBilateralParams {
  PlaneParams planes;
  EdgeStopParams stops;
  QuellFloat sigma;    // pixels, of a perfectly rough surface
  QuellInt alongRows;  // 1: taps of a row, 0: of a column
} SeparableBilateralParams;

QUELL_NAMESPACE_END

// Taps reach so far to either side, pixels: two of the paper's deviations.
#define QUELL_SEPARABLE_REACH 14
// Power of roughness that the deviation follows, and the least one, pixels (Mara et al. 2017, section 3.4).
#define QUELL_SEPARABLE_POWER 0.1f
#define QUELL_SEPARABLE_LEAST_SIGMA 1e-3f

#endif

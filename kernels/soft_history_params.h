// Parameters of the stage soft_history.
#ifndef QUELL_SOFT_HISTORY_PARAMS_H
#define QUELL_SOFT_HISTORY_PARAMS_H

#include "common/reprojection_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct SoftHistoryParams {
  ReprojectionParams reprojection;
  PlaneParams planes;
  QuellFloat hysteresis;  // most weight of history, [0, 1)
  // Distance of history from where it is expected up to which it is trusted wholly, and from which on not at all: scene
  // units, plus scene units per clip.w of the pixel.
  QuellFloat nearDistance;
  QuellFloat nearFootprint;
  QuellFloat farDistance;
  QuellFloat farFootprint;
  QuellFloat
      clampSigma;  // standard deviations of the newest samples around that history may lie off their mean; 0: any
  QuellInt meanFirst;  // 1: history weighs at most as a mean over its frames does
  QuellInt
      trustsMotion;  // 1: accepted taps count wholly: with motion vectors positions are not where they were
} SoftHistoryParams;

QUELL_NAMESPACE_END

#endif

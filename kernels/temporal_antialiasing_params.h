// Parameters of the stage temporal_antialiasing.
#ifndef QUELL_TEMPORAL_ANTIALIASING_PARAMS_H
#define QUELL_TEMPORAL_ANTIALIASING_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct TemporalAntialiasingParams {
  PlaneParams planes;
  ImageViewParams output;
  QuellFloat newestWeight;  // weight of the newest frame, (0, 1]
  QuellInt jitters;  // whether this frame or the one before is sampled off the pixel centres; only with SKIP
} TemporalAntialiasingParams;

QUELL_NAMESPACE_END

#endif

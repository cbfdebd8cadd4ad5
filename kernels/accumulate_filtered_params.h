// Parameters of the stage accumulate_filtered.
#ifndef QUELL_ACCUMULATE_FILTERED_PARAMS_H
#define QUELL_ACCUMULATE_FILTERED_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct AccumulateFilteredParams {
  PlaneParams planes;
  QuellFloat leastWeight;  // least weight of the newest filtered frame, (0, 1]
} AccumulateFilteredParams;

QUELL_NAMESPACE_END

#endif

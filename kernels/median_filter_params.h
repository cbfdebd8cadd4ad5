// Parameters of the stage median_filter.
#ifndef QUELL_MEDIAN_FILTER_PARAMS_H
#define QUELL_MEDIAN_FILTER_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct MedianFilterParams {
  PlaneParams planes;
} MedianFilterParams;

QUELL_NAMESPACE_END

#endif

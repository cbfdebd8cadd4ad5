// Parameters of the stage box_filter.
#ifndef QUELL_BOX_FILTER_PARAMS_H
#define QUELL_BOX_FILTER_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct BoxFilterParams {
  PlaneParams grid;    // of each plane
  QuellInt count;      // planes
  QuellInt radius;     // elements to either side; >= 0
  QuellInt alongRows;  // 1: sums of neighbours in a row, 0: in a column
} BoxFilterParams;

QUELL_NAMESPACE_END

#endif

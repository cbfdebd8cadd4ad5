// Parameters of resample_history.
#ifndef QUELL_RESAMPLE_HISTORY_PARAMS_H
#define QUELL_RESAMPLE_HISTORY_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct ResampleHistoryParams {
  PlaneParams source;
  PlaneParams target;
  QuellInt planeCount;
} ResampleHistoryParams;

QUELL_NAMESPACE_END

#endif

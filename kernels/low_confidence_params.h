// Parameters of the stage low_confidence, and its grid.
#ifndef QUELL_LOW_CONFIDENCE_PARAMS_H
#define QUELL_LOW_CONFIDENCE_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct LowConfidenceParams {
  PlaneParams planes;
  PlaneParams cells;
} LowConfidenceParams;

QUELL_NAMESPACE_END

// A cell holds whole work-items, however many lanes these have.
#define QUELL_CONFIDENCE_CELL_WIDTH 16  // pixels
#define QUELL_CONFIDENCE_CELL_HEIGHT 8

#endif

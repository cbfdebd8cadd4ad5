// low_confidence: the least confidence in history of the pixels of a cell.
// Paper:   Mara et al. 2017, stage 5, which looks for the minimum over squares of pixels in two one-dimensional passes; here
//          the first step of it takes cells of 16x8 pixels together, and box_filter does the passes over these.
// In:      confidence of the first signal, guides (its weights). Out: cellConfidence (1 float a cell); 1 where no pixel has a
//          sample.
// Border:  pixels outside the image are left out.
// Grid:    one work-item a cell.
#include "common/planes.h"
#include "low_confidence_ports.h"

__kernel void low_confidence(STAGE_ARGUMENTS(LOW_CONFIDENCE) LowConfidenceParams params) {
  const PlaneParams planes = params.planes;
  const int cellX = (int)get_global_id(0);
  const int cellY = (int)get_global_id(1);
  if (cellX >= params.cells.width || cellY >= params.cells.height) return;
  const int left = cellX * QUELL_CONFIDENCE_CELL_WIDTH;
  const int top = cellY * QUELL_CONFIDENCE_CELL_HEIGHT;
  const int bottom = min(top + QUELL_CONFIDENCE_CELL_HEIGHT, planes.height);
  __global const float* weights = guides + QUELL_GUIDE_WEIGHT * planes.stride;
  float least = 1.0f;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < left + QUELL_CONFIDENCE_CELL_WIDTH; x += QUELL_LANES) {
      const int index = planeIndex(planes, x, y);
      const intL counts = insideColumns(planes, x + LANE_INDEX) && loadLanes(weights + index) > 0.0f;
      const floatL here = counts ? loadLanes(confidence + index) : ONE_LANES;
      for (int lane = 0; lane < QUELL_LANES; ++lane) least = min(least, ((const float*)&here)[lane]);
    }
  }
  cellConfidence[planeIndex(params.cells, cellX, cellY)] = least;
}

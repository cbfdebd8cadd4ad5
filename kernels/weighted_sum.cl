// weighted_sum: evaluates the block's fit with the noise-free features.
// Paper:   Koskela et al. 2019, eq. (6): the synthesis uses the noise-free buffers T; negative results are clamped to 0
//          as in the reference implementation.
// In:      records of the stages fit or gram_solve, guides of this frame; materials (4 planes) where a feature needs
//          them. Out: fitted irradiance (3 planes per signal, of which those of QUELL_SIGNAL are written), >= 0; 0 at
//          background.
// Grid:    work-items follow the displaced blocks, so that all lanes of one share a record; the parts of them outside
//          the image fall into the margins of the planes.
#include "common/fit_features.h"
#include "common/planes.h"
#include "common/surfaces.h"
#include "weighted_sum_ports.h"

#define ITEMS_PER_BLOCK_ROW (QUELL_BLOCK_EDGE / QUELL_LANES)

__kernel void weighted_sum(STAGE_ARGUMENTS(WEIGHTED_SUM) FitParams params) {
  const int itemX = (int)get_global_id(0);
  const int rowY = (int)get_global_id(1);
  const int x = params.blockOffsetX + itemX * QUELL_LANES;
  const int y = params.blockOffsetY + rowY;
  if (itemX >= params.blocksX * ITEMS_PER_BLOCK_ROW || x <= -QUELL_LANES || x >= params.planes.width ||
      y < 0 || y >= params.planes.height)
    return;
  if (SKIP && !anySurface(surfaces, params.planes, x, y, x + QUELL_LANES - 1, y)) return;
  const int block = (rowY / QUELL_BLOCK_EDGE) * params.blocksX + itemX / ITEMS_PER_BLOCK_ROW;
  __global const float* record = fitRecords + block * QUELL_FIT_RECORD;
  const int index = planeIndex(params.planes, x, y);
  const int stride = params.planes.stride;

  Guide guide;
  guide.position = loadLanes3(guides + QUELL_GUIDE_POSITION * stride, index, stride);
  guide.normal = loadLanes3(guides + QUELL_GUIDE_NORMAL * stride, index, stride);
#if QUELL_USES_PIXEL
  guide.column = TO_FLOAT(x + LANE_INDEX);
  guide.row = (floatL)((float)y);
#endif
#if QUELL_USES_MATERIAL
  guide.albedo = loadLanes3(materials + QUELL_MATERIAL_ALBEDO * stride, index, stride);
  guide.roughness = loadLanes(materials + QUELL_MATERIAL_ROUGHNESS * stride + index);
#endif
  const float3L sum = evaluateFit(record, guide, params.viewAxis);
  const intL surface = dot3(guide.normal, guide.normal) > 0.0f && isFinite3(sum);
  storeLanes3(select3(surface, clamp3(sum, 0.0f, QUELL_MAX_RADIANCE), splat3(0.0f)),
              fitted + 3 * QUELL_SIGNAL * stride, index, stride);
}

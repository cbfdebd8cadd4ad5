// tone_map: linear radiance to display-encoded values: clamp to [0, 1], gamma 2.2.
// Paper:   Koskela et al. 2019, reference implementation (the paper leaves the tone map to the renderer).
// In:      linear radiance (3 planes). Out: encoded values in [0, 1] as 3 planes (for temporal_antialiasing) or in the
//          caller's layout (without it).
#include "common/display_encoding.h"
#include "common/image_access.h"
#include "common/planes.h"
#include "common/surfaces.h"
#include "tone_map_params.h"

__kernel void tone_map(__global const float* linearPlanes, __global float* encodedPlanes,
                       __global uchar* outputData, __global const uchar* surfaces, ToneMapParams params) {
  const PlaneParams planes = params.planes;
  const int x = (int)get_global_id(0) * QUELL_LANES;
  const int y = (int)get_global_id(1);
  if (x >= planes.width || y >= planes.height) return;
#if SKIP
  if (isBackground(surfaces, planes, x, y)) return;  // the stage background has done it
#endif
  const int index = planeIndex(planes, x, y);
  const float3L encoded = encodeDisplay3(loadLanes3(linearPlanes, index, planes.stride));
#if WRITE_PLANES
  storeLanes3(encoded, encodedPlanes, index, planes.stride);
#endif
#if OUTPUT_FORMAT
  STORE_PIXELS(OUTPUT, encoded, outputData, params.output, x, y, min(QUELL_LANES, planes.width - x));
#endif
}

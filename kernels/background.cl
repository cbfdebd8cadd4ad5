// background: where a work-item's pixels show nothing but background, everything from radiance to display in one pass,
//          so that remodulate and temporal_antialiasing can leave them out.
// Source:  ours; radiance and encoding are those of remodulate. Without sub-pixel jitter the background is
//          met in the same way in every frame and needs no antialiasing over time.
// In:      the caller's radiance (or diffuse and glossy radiance), emission, albedo and gloss colour; surfaces (see
//          common/surfaces.h).
// Out:     radiance in the caller's layout, linear and encoded for display; as 3 planes near surfaces, where it bounds the
//          history of antialiasing, and as history of temporal_antialiasing (3 planes).
#include "background_ports.h"
#include "common/display_encoding.h"
#include "common/material.h"
#include "common/output_images.h"
#include "common/surfaces.h"

// With nothing to take out and add back, radiance is the result.
#define RADIANCE_IS_ALL (!DEMODULATED && QUELL_SIGNALS == 1 && !EMISSION_FORMAT)

// Radiance of the background, as remodulate has it.
QUELL_INLINE float3L backgroundRadiance(FrameImages images, int x, int y, int lanes) {
#if RADIANCE_IS_ALL
  const float3L radiance = LOAD_IMAGE(radiance, RADIANCE, x, y, lanes);
  const intL whole = isFinite3(radiance);
  if (!anyLane(!whole)) return radiance;
#endif
  const Material material = loadMaterial(images, splat3(1.0f), x, y, lanes);
  float3L sum = material.emission;
  for (int s = 0; s < QUELL_SIGNALS; ++s)
    sum = add3(sum, multiply3(material.signals[s].tint, material.signals[s].value));
#if RADIANCE_IS_ALL
  sum = select3(whole, radiance, sum);
#endif
  return sum;
}

#if ANTIALIAS
// Whether antialiasing looks at these pixels: it works on background next to surfaces as well, and there on the 3x3
// pixels around.
QUELL_INLINE int isSeenByAntialiasing(__global const uchar* surfaces, PlaneParams planes, int x, int y) {
  const int reach = 2;
  return anySurface(surfaces, planes, x - reach, y - reach, x + QUELL_LANES - 1 + reach, y + reach);
}
#endif

__kernel void background(STAGE_ARGUMENTS(BACKGROUND) BackgroundParams params) {
  BEGIN_PIXELS(params.planes);
  BIND_FRAME_IMAGES(BACKGROUND, params.images);
  if (!isBackground(surfaces, planes, x, y)) return;
  const int lanes = min(QUELL_LANES, planes.width - x);
  const float3L radiance = clamp3(backgroundRadiance(images, x, y, lanes), 0.0f, QUELL_MAX_RADIANCE);
#if ANTIALIAS
  if (params.finish == 0 || isSeenByAntialiasing(surfaces, planes, x, y))
    storeLanes3(radiance, beforeAntialiasing, index, stride);
  if (params.finish != 0) storeLanes3(radiance, antialiased, index, stride);
#endif
#if LINEAR_FORMAT
  if (!ANTIALIAS_LINEAR || params.finish != 0)
    STORE_LINEAR(radiance, linearData, params.outputs.linear, x, y, lanes);
#endif
#if DISPLAY_FORMAT
  if (params.finish != 0)
    STORE_DISPLAY(encodeDisplay(radiance, params.exposure), displayData, params.outputs.display, x, y, lanes);
#endif
}

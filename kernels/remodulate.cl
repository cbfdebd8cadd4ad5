// remodulate: filtered irradiance back to radiance, per signal divisor * filtered, plus emission; and its display encoding.
// Paper:   Koskela et al. 2019, post-processing: albedo, removed before phase I, is multiplied back. What the divisor is
//          stands in common/demodulation.h. Display encoding: reference implementation (the paper leaves the tone map to
//          the renderer).
// In:      filtered irradiance (3 planes per signal), guides, the caller's radiance (or diffuse and glossy radiance),
//          emission, albedo and gloss colour; F_beta (3 planes) where light was divided by it; with KEEP_LIGHT gains
//          (1 float per tile and signal, see light_gain.cl), interpolated between the centres of tiles.
// Out:     linear radiance, finite, in [0, 65504]: as 3 planes for temporal_antialiasing, which then writes the display
//          image, and with ANTIALIAS_LINEAR the linear one, or in the caller's layout; without it encoded for display, in
//          [0, 1], as well; of each what the caller wants.
//          Background, broken surfaces and emitters pass the signal through; a missing sample there is black.
#include "common/display_encoding.h"
#include "common/guides.h"
#include "common/luminance.h"
#include "common/material.h"
#include "common/output_images.h"
#include "common/planes.h"
#include "common/surfaces.h"
#include "common/tiles.h"
#include "light_params.h"
#include "remodulate_ports.h"

#if KEEP_LIGHT
QUELL_INLINE float3L giveLightBack(float3L filtered, floatL gain) {
  const floatL ratio = 1.0f + gain * luminance(filtered);
  return scale3(filtered, clampLanes(ratio, QUELL_LIGHT_LEAST_RATIO, QUELL_LIGHT_MOST_RATIO));
}
#endif

// Radiance of one signal; its filtered value counts only where it was `filtered`. Of two signals weak channels pass through.
QUELL_INLINE float3L remodulateSignal(Signal signal, float3L value, intL filtered) {
  const float3L product = multiply3(signal.divisor, value);
  float3L radiance = select3(filtered, product, signal.value);
#if QUELL_SIGNALS == 2
  const intL some = signal.weak != QUELL_ALL_WEAK;
  radiance.x = some && (signal.weak & QUELL_WEAK_X) != 0 ? signal.value.x : radiance.x;
  radiance.y = some && (signal.weak & QUELL_WEAK_Y) != 0 ? signal.value.y : radiance.y;
  radiance.z = some && (signal.weak & QUELL_WEAK_Z) != 0 ? signal.value.z : radiance.z;
#endif
  return multiply3(signal.tint, radiance);
}

__kernel void remodulate(STAGE_ARGUMENTS(REMODULATE) RemodulateParams params) {
  BEGIN_PIXELS(params.planes);
  BIND_FRAME_IMAGES(REMODULATE, params.images);
  LEAVE_OUT_BACKGROUND(NOTHING_ELSE)  // the stage background has done it
  const int lanes = min(QUELL_LANES, planes.width - x);

  const float3L normal = loadLanes3(guides + QUELL_GUIDE_NORMAL * stride, index, stride);
  const Material material = loadMaterial(images, keptFBeta(fBeta, index, stride), x, y, lanes);
  const intL surface = dot3(normal, normal) > 0.0f;
  float3L radianceOut = material.emission;
#if KEEP_LIGHT
  const TileMix mix = mixTiles(params.tilesX, params.tilesY, x, y);
#endif
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const Signal signal = material.signals[s];
    float3L value = loadLanes3(filtered + 3 * s * stride, index, stride);
#if KEEP_LIGHT
    value = giveLightBack(value, mixedValue(lightGain + s * params.tilesX * params.tilesY, mix));
#endif
    // A sample that is there and has no weight is an emitter's or of a lobe that is not there.
    const intL counts =
        loadLanes(guides + (QUELL_GUIDE_WEIGHT + s) * stride + index) > 0.0f || !signal.finite;
    radianceOut = add3(radianceOut, remodulateSignal(signal, value, surface && counts));
  }
  radianceOut = clamp3(radianceOut, 0.0f, QUELL_MAX_RADIANCE);
#if LINEAR_FORMAT && !ANTIALIAS_LINEAR
  STORE_LINEAR(radianceOut, linearData, params.outputs.linear, x, y, lanes);
#endif
#if WRITE_PLANES
  storeLanes3(radianceOut, beforeAntialiasing, index, stride);
#elif DISPLAY_FORMAT
  STORE_DISPLAY(encodeDisplay(radianceOut, params.exposure), displayData, params.outputs.display, x, y,
                lanes);
#endif
}

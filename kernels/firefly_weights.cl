// firefly_weights: weights of pixels in a filter, less for those that are far brighter than all around them.
// Source:  see common/fireflies.h. Methods with moments of luminance have the stage variance do it, which knows better
//          whether a pixel's light comes from one sample.
// In:      irradiance (3 planes per signal), guides (the weights alone), history length (bytes per signal).
// Out:     tapWeights (1 plane per signal): those of the guides, less for fireflies; 0 in background.
// Border:  pixels outside the image and those without a sample are left out.
#include "common/fireflies.h"
#include "common/surfaces.h"
#include "firefly_weights_ports.h"

__kernel void firefly_weights(STAGE_ARGUMENTS(FIREFLY_WEIGHTS) FireflyWeightsParams params) {
  BEGIN_PIXELS(params.planes);
  LEAVE_OUT_BACKGROUND(storeZeroWeights(tapWeights, index, stride))
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    const Ring ring = {irradiance + 3 * s * stride, guides + (QUELL_GUIDE_WEIGHT + s) * stride, planes, x, y};
    const intL isLong = loadByteLanes(historyLength + s * stride + index) >= QUELL_FIREFLY_LEAST_HISTORY;
    const floatL own = luminance(loadLanes3(ring.irradiance, index, stride));
    const floatL share = fireflyShare(isLong, own, params.fireflyRatio, ring);
    storeLanes(share * loadLanes(ring.weights + index), tapWeights + s * stride + index);
  }
}

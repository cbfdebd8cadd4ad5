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
    __global const float* signal = irradiance + 3 * s * stride;
    __global const float* weights = guides + (QUELL_GUIDE_WEIGHT + s) * stride;
    const intL length = loadByteLanes(historyLength + s * stride + index);
    const floatL share =
        fireflyShare(length >= QUELL_FIREFLY_LEAST_HISTORY, luminance(loadLanes3(signal, index, stride)),
                     params.fireflyRatio, signal, weights, planes, x, y);
    storeLanes(share * loadLanes(weights + index), tapWeights + s * stride + index);
  }
}

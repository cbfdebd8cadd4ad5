// guided_solve: from the sums over windows to the coefficients of a guided filter, one window a lane.
// Source:  He et al. 2013, eq. (19) and (20), for guides of several channels: a = (covariance of the guides + epsilon)^-1
//          times the covariance of guides and colour, b = mean colour - a times the mean guides; solved as in
//          normal_equations.h, where windows of very few pixels get their mean.
//          Depth is divided by its root mean square over the window, so that epsilon means the same share of it near and
//          far, and in scenes of any unit; He et al. and Bauszat et al. 2011 have guides in [0, 1].
// In:      windowMoments: moments of guided_moments, summed over windows.
// Out:     coefficients per signal and window (guided_params.h), for guides as they are; all 0 without any sample.
#include "common/planes.h"
#include "guided_solve_ports.h"
#include "normal_equations.h"

// Takes the sums to depths that are divided by their root mean square; returns what they are multiplied by.
QUELL_INLINE floatL scaleDepth(floatL* sums) {
  const floatL weight = sums[QUELL_GRAM_INDEX(0, 0)];
  const floatL square = sums[QUELL_GRAM_INDEX(QUELL_GUIDED_DEPTH, QUELL_GUIDED_DEPTH)];
  const floatL mean = square / (weight > 0.0f ? weight : ONE_LANES);
  const float least = 1.0f / (QUELL_GUIDED_MOST_DEPTH * QUELL_GUIDED_MOST_DEPTH);
  const floatL scale = 1.0f / SQRT(maxLanes(mean, (floatL)(least)));
  UNROLL_ON_GPU
  for (int k = 0; k < QUELL_GUIDED_DEPTH; ++k) sums[QUELL_GRAM_INDEX(k, QUELL_GUIDED_DEPTH)] *= scale;
  UNROLL_ON_GPU
  for (int k = QUELL_GUIDED_DEPTH; k < QUELL_GRAM_COLUMNS; ++k)
    sums[QUELL_GRAM_INDEX(QUELL_GUIDED_DEPTH, k)] *= scale;
  sums[QUELL_GRAM_INDEX(QUELL_GUIDED_DEPTH, QUELL_GUIDED_DEPTH)] *= scale;
  return scale;
}

__kernel void guided_solve(STAGE_ARGUMENTS(GUIDED_SOLVE) GuidedParams params) {
  BEGIN_PIXELS(params.cells);
  for (int s = 0; s < QUELL_SIGNALS; ++s) {
    floatL sums[QUELL_GRAM_SUMS];
    UNROLL_ON_GPU
    for (int k = 0; k < QUELL_GUIDED_SUMS; ++k)
      sums[k] = loadLanes(windowMoments + (s * QUELL_GUIDED_SUMS + k) * stride + index);
    const intL used = sums[QUELL_GRAM_INDEX(0, 0)] > 0.0f;
    const floatL depthScale = scaleDepth(sums);
    floatL solved[QUELL_FEATURES][QUELL_FIT_CHANNELS];
    solveWindow(sums, params.epsilon, solved);
    __global float* planesOfSignal = coefficients + s * QUELL_GUIDED_COEFFICIENTS * stride + index;
    UNROLL_ON_GPU
    for (int j = 0; j < QUELL_FEATURES; ++j) {
      const floatL scale = j == QUELL_GUIDED_DEPTH ? depthScale : ONE_LANES;
      UNROLL_ON_GPU
      for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
        storeLanes(used ? solved[j][c] * scale : ZERO_LANES,
                   planesOfSignal + (j * QUELL_FIT_CHANNELS + c) * stride);
    }
    storeLanes(used ? ONE_LANES : ZERO_LANES, planesOfSignal + QUELL_GUIDED_USED * stride);
  }
}

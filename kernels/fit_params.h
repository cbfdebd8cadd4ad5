// Parameters of the stages fit and weighted_sum: blocks, features and the record that joins the two stages.
#ifndef QUELL_FIT_PARAMS_H
#define QUELL_FIT_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct FitParams {
  PlaneParams planes;
  QuellInt blockOffsetX;  // column of the first block's first pixel, in [-32, -1]
  QuellInt blockOffsetY;  // row of it, in the same range
  QuellInt blocksX;       // blocks in a row of the grid
  QuellInt blocksY;
  QuellUint noiseSeed;        // changes every frame
  QuellFloat noiseAmplitude;  // of the stochastic regularisation, scaled feature units; >= 0
} FitParams;

QUELL_NAMESPACE_END

// Edge of a block in pixels (paper: 32x32 blocks).
#define QUELL_BLOCK_EDGE 32
#define QUELL_BLOCK_PIXELS (QUELL_BLOCK_EDGE * QUELL_BLOCK_EDGE)
// Features T = [1, nx, ny, nz, wx, wy, wz, wx^2, wy^2, wz^2] (paper, section on the choice of feature buffers).
#define QUELL_FEATURES 10
// Colour channels fitted at once, as further columns of the augmented matrix.
#define QUELL_FIT_CHANNELS 3
#define QUELL_FIT_COLUMNS (QUELL_FEATURES + QUELL_FIT_CHANNELS)

// Record of one block, in floats: coefficients [feature][channel], then anchor (3) and scale (3) of the positions:
// w = (position - anchor) * scale.
#define QUELL_FIT_ANCHOR (QUELL_FEATURES * QUELL_FIT_CHANNELS)
#define QUELL_FIT_SCALE (QUELL_FIT_ANCHOR + 3)
#define QUELL_FIT_RECORD (QUELL_FIT_SCALE + 3)

// Positions are scaled to [0, 1] where the block's range exceeds this share of the view distance; below, they are
// rounding noise and divided by the distance, which leaves them for the injected noise to drown.
#define QUELL_FIT_LEAST_RANGE 1e-4f
// A column whose residual energy is below this share of the sum of weights is a combination of those before it; it
// gets no coefficient. Far above float rounding (1e-13) and far below the injected noise (3e-5).
#define QUELL_FIT_RANK_TOLERANCE 1e-10f

#endif

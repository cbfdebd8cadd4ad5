// Parameters of the stages fit and weighted_sum: blocks, features and the record that joins the two stages.
#ifndef QUELL_FIT_PARAMS_H
#define QUELL_FIT_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct FitParams {
  // Camera-relative position -> view depth (.xyz), for the feature `depth`. Orthographic cameras: 0.
  QuellFloat4 viewAxis;
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
// The features. Which there are is decided by compile options that the host writes from the setting `features`
// (host/stages/feature_list.hpp); without any they are T = [1, nx, ny, nz, wx, wy, wz, wx^2, wy^2, wz^2] (paper, section
// on the choice of feature buffers). See common/fit_features.h for the names in the lists.
#ifndef QUELL_FEATURES
#define QUELL_FEATURES 10
// clang-format off
#define QUELL_FEATURE_LIST                          \
  FEATURE(1, NX) FEATURE(2, NY) FEATURE(3, NZ)       \
  FEATURE(4, S(0)) FEATURE(5, S(1)) FEATURE(6, S(2)) \
  FEATURE(7, S(0) * S(0)) FEATURE(8, S(1) * S(1)) FEATURE(9, S(2) * S(2))
// clang-format on
// Unbounded variables of a pixel, which every block or tile scales to [0, 1]; positions, if any, come first.
#define QUELL_SCALED 3
#define QUELL_SCALED_POSITIONS 1
#define QUELL_SCALED_LIST SCALED(0, PX) SCALED(1, PY) SCALED(2, PZ)
#endif
// The most features, the constant one included: rows of R lie in the first vector of rows (fit.cl).
#define QUELL_MOST_FEATURES 16
// Colour channels fitted at once, as further columns of the augmented matrix.
#define QUELL_FIT_CHANNELS 3
#define QUELL_FIT_COLUMNS (QUELL_FEATURES + QUELL_FIT_CHANNELS)

// Record of one block, in floats: coefficients [feature][channel], anchors and scales of the scaled variables v, as in
// (v - anchor) * scale, and 1 if any pixel had a sample (else 0); padded to 16 bytes.
#define QUELL_FIT_ANCHOR_OF(features) ((features)*QUELL_FIT_CHANNELS)
#define QUELL_FIT_SCALE_OF(features, scaled) (QUELL_FIT_ANCHOR_OF(features) + (scaled))
#define QUELL_FIT_USABLE_OF(features, scaled) (QUELL_FIT_SCALE_OF(features, scaled) + (scaled))
#define QUELL_FIT_RECORD_OF(features, scaled) ((QUELL_FIT_USABLE_OF(features, scaled) + 4) / 4 * 4)
#define QUELL_FIT_USABLE QUELL_FIT_USABLE_OF(QUELL_FEATURES, QUELL_SCALED)
#define QUELL_FIT_ANCHOR QUELL_FIT_ANCHOR_OF(QUELL_FEATURES)
#define QUELL_FIT_SCALE QUELL_FIT_SCALE_OF(QUELL_FEATURES, QUELL_SCALED)
#define QUELL_FIT_RECORD QUELL_FIT_RECORD_OF(QUELL_FEATURES, QUELL_SCALED)

// Planes of the caller's images that features can be made of: written by the stage material_guides.
#define QUELL_MATERIAL_ALBEDO 0     // 3 planes
#define QUELL_MATERIAL_ROUGHNESS 3  // 1 plane
#define QUELL_MATERIAL_PLANES 4

// Variables are scaled to [0, 1] where the block's range exceeds this share of the view distance; below, it is
// rounding noise and divided by the distance, which leaves them for the injected noise to drown.
#define QUELL_FIT_LEAST_RANGE 1e-4f
// A column whose residual energy is below this share of the sum of weights is a combination of those before it; it
// gets no coefficient. Far above float rounding (1e-13) and far below the injected noise (3e-5).
#define QUELL_FIT_RANK_TOLERANCE 1e-10f

#endif

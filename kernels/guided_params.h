// Parameters and records of the stages guided_moments, guided_solve and guided_evaluate.
#ifndef QUELL_GUIDED_PARAMS_H
#define QUELL_GUIDED_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct GuidedParams {
  PlaneParams planes;  // of the image
  PlaneParams cells;   // of the grid of cells, SUBSAMPLING pixels square each
  QuellFloat epsilon;  // added to the variance of each guide; of depth as a share of its mean square; > 0
} GuidedParams;

QUELL_NAMESPACE_END

// The guides behind the constant 1: the world-space normal and view depth.
#define QUELL_GUIDED_FEATURES 5
#define QUELL_GUIDED_DEPTH 4  // number of that feature
#define QUELL_GUIDED_CHANNELS 3
// A cell's planes of sums, per signal: of the upper triangle of the Gram matrix of [features | colour], row by row, the rows
// of the features; as gram_params.h has it, without the products of colours.
#define QUELL_GUIDED_SUMS \
  (QUELL_GUIDED_FEATURES * (QUELL_GUIDED_FEATURES + 1) / 2 + QUELL_GUIDED_FEATURES * QUELL_GUIDED_CHANNELS)
// A cell's planes of coefficients, per signal: [feature][channel], then how many windows they are sums of.
#define QUELL_GUIDED_USED (QUELL_GUIDED_FEATURES * QUELL_GUIDED_CHANNELS)
#define QUELL_GUIDED_COEFFICIENTS (QUELL_GUIDED_USED + 1)

// Depths are limited to this, scene units: sums of their squares are finite then, and their mean square is at least the
// inverse's square.
#define QUELL_GUIDED_MOST_DEPTH 1e15f

#endif

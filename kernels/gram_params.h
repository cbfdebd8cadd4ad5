// Parameters and layouts of the stages gram_sums, gram_solve and blended_sum.
#ifndef QUELL_GRAM_PARAMS_H
#define QUELL_GRAM_PARAMS_H

#include "common/types.h"
#include "fit_params.h"

QUELL_NAMESPACE_BEGIN

typedef struct GramParams {
  PlaneParams planes;
  QuellInt
      tileOffsetX;  // column of the first tile's first pixel: [-32, -1] for blocks, (-edge, 0] for overlap
  QuellInt tileOffsetY;  // row of it
  QuellInt tilesX;       // tiles in a row of the grid
  QuellInt tilesY;
  QuellInt tileStride;       // elements from one plane of the tile buffer to the next
  QuellFloat noiseVariance;  // of the regularising noise, scaled feature units squared; >= 0
} GramParams;

QUELL_NAMESPACE_END

// Sums of a tile: the upper triangle, row by row, of the Gram matrix of [features | colour], rows weighted.
#define QUELL_GRAM_SUMS (QUELL_FIT_COLUMNS * (QUELL_FIT_COLUMNS + 1) / 2)
// Element of the triangle for columns a <= b.
#define QUELL_GRAM_INDEX(a, b) ((a)*QUELL_FIT_COLUMNS - (a) * ((a)-1) / 2 + (b) - (a))
// Planes of the tile buffer: the sums, then the range of the positions (camera-relative, scene units).
#define QUELL_GRAM_LOW QUELL_GRAM_SUMS         // 3 planes; above the highest where no pixel has a weight
#define QUELL_GRAM_HIGH (QUELL_GRAM_SUMS + 3)  // 3 planes
#define QUELL_GRAM_PLANES (QUELL_GRAM_SUMS + 6)

// A normalised pivot at or below this is rounding noise: the feature is a combination of those before it and gets no
// coefficient. Sums of a thousand products carry a relative error of about 1e-6.
#define QUELL_GRAM_PIVOT_TOLERANCE 2e-6f
// A variance at or below this share of the mean square is rounding noise: the feature is constant.
#define QUELL_GRAM_VARIANCE_TOLERANCE 2e-6f
// A window with a smaller sum of weights, two pixels a coefficient, gets its mean alone: a fit would follow the noise
// of those pixels and be extrapolated to all that have no sample.
#define QUELL_GRAM_LEAST_WEIGHT (2.0f * QUELL_FEATURES)

#endif

// Parameters and layouts of the stages gram_sums, gram_solve and blended_sum.
#ifndef QUELL_GRAM_PARAMS_H
#define QUELL_GRAM_PARAMS_H

#include "common/types.h"
#include "fit_params.h"

QUELL_NAMESPACE_BEGIN

typedef struct GramParams {
  QuellFloat4 viewAxis;  // as in FitParams
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

// Features that the sums are made of. With overlapping windows these are the features of the fit, followed by those
// that a change of scaling brings in: (r w + t)^2 has a linear term.
#ifndef QUELL_GRAM_FEATURES
#define QUELL_GRAM_FEATURES QUELL_FEATURES
#endif
// The most of them that fit into work-group memory and the list of products in gram_sums.cl.
#define QUELL_MOST_GRAM_FEATURES 24
#define QUELL_GRAM_COLUMNS (QUELL_GRAM_FEATURES + QUELL_FIT_CHANNELS)

// Sums of a tile: the upper triangle, row by row, of the Gram matrix of [features | colour], rows weighted.
#define QUELL_GRAM_SUMS_OF(features) \
  (((features) + QUELL_FIT_CHANNELS) * ((features) + QUELL_FIT_CHANNELS + 1) / 2)
#define QUELL_GRAM_SUMS QUELL_GRAM_SUMS_OF(QUELL_GRAM_FEATURES)
// Element of the triangle for columns a <= b.
#define QUELL_GRAM_INDEX_OF(columns, a, b) ((a) * (columns) - (a) * ((a)-1) / 2 + (b) - (a))
#define QUELL_GRAM_INDEX(a, b) QUELL_GRAM_INDEX_OF(QUELL_GRAM_COLUMNS, a, b)
// Planes of the tile buffer: the sums, then the range of the scaled variables (camera-relative, scene units or pixels).
#define QUELL_GRAM_LOW QUELL_GRAM_SUMS  // a plane a variable; above the highest where no pixel has a weight
#define QUELL_GRAM_HIGH (QUELL_GRAM_SUMS + QUELL_SCALED)
#define QUELL_GRAM_PLANES_OF(features, scaled) (QUELL_GRAM_SUMS_OF(features) + 2 * (scaled))
#define QUELL_GRAM_PLANES QUELL_GRAM_PLANES_OF(QUELL_GRAM_FEATURES, QUELL_SCALED)

// A normalised pivot at or below this is rounding noise: the feature is a combination of those before it and gets no
// coefficient. Sums of a thousand products carry a relative error of about 1e-6.
#define QUELL_GRAM_PIVOT_TOLERANCE 2e-6f
// A variance at or below this share of the mean square is rounding noise: the feature is constant.
#define QUELL_GRAM_VARIANCE_TOLERANCE 2e-6f
// A window with a smaller sum of weights, two pixels a coefficient, gets its mean alone: a fit would follow the noise
// of those pixels and be extrapolated to all that have no sample.
#define QUELL_GRAM_LEAST_WEIGHT (2.0f * QUELL_FEATURES)

#endif

// Parameters and records of the stages change_sums, change_weight and follow_change.
#ifndef QUELL_CHANGE_PARAMS_H
#define QUELL_CHANGE_PARAMS_H

#include "common/innovation.h"
#include "common/tiles_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct ChangeParams {
  PlaneParams planes;
  QuellInt tilesX;
  QuellInt tilesY;
  QuellInt restarted;           // 1: there is no frame before, 0: there is
  QuellFloat sumsKept;          // share of the sums of the frame before that is kept, [0, 1)
  QuellFloat thresholdSquared;  // deviation squared, in variances, up to which a difference counts as noise
  QuellFloat recentChangeThresholdSquared;  // the same where light has changed lately
  QuellFloat gain;                          // excess over it at which the weight is half of mostWeight, > 0
  QuellFloat mostWeight;                    // largest weight of the newest sample, (0, 1]
  QuellFloat leastWeight;                   // as in accumulate_noisy
  QuellFloat momentsLeastWeight;            // as in accumulate_noisy
} ChangeParams;

QUELL_NAMESPACE_END

// A tile's record, per signal: pixels that could be compared; for luminance and for chrominance the sum of their
// differences and of the squares of these; the odds that neighbours agree; and what fills up a vector.
#define QUELL_CHANGE_COUNT 0
#define QUELL_CHANGE_SUM(plane) (1 + 2 * (plane))
#define QUELL_CHANGE_SQUARES(plane) (2 + 2 * (plane))
#define QUELL_CHANGE_AGREEMENT 5
#define QUELL_CHANGE_RECORD 8

// Neighbours whose differences from their histories differ by this share of themselves agree by half: noise is 1/10 as
// steady in less than a fifth of all pairs (odds below 1/4), screens and hard shadows in nearly all.
#define QUELL_CHANGE_AGREED_SHARE 0.1f
// Least share of a tile's pixels that must have been compared, and the least chance left that they do not agree: what floats
// can tell.
#define QUELL_CHANGE_AGREED_PIXELS 0.5f
#define QUELL_CHANGE_LEAST_DOUBT 1e-3f

// Windows are tents over 3x3 and 5x5 tiles: the small one sees where the light changed, the large one how faintly.
#define QUELL_CHANGE_SMALL_WINDOW 1
#define QUELL_CHANGE_LARGE_WINDOW 2

// A window with less than this share of its pixels compared says nothing about change.
#define QUELL_CHANGE_LEAST_SHARE 0.0625f

// Recent change: the share that is kept of the frame before, which makes it a mean over some ten frames; the largest
// significance that enters, so that one jump is forgotten as soon; up to which tiles are still (noise alone: 1.1)
// and from which on changing. Source: sweep, docs/quell-sweep.md.
#define QUELL_RECENT_CHANGE_KEPT 0.9f
#define QUELL_RECENT_CHANGE_MOST 16.0f
#define QUELL_RECENT_CHANGE_NONE 1.4f
#define QUELL_RECENT_CHANGE_SURE 2.4f

// Least spread of the differences, luminance squared: where all are equal there is no noise to compare with. Far below the
// noise of a scene a millionth as bright as is usual, and so large that the quotient of any difference is finite.
#define QUELL_CHANGE_LEAST_SPREAD 1e-20f

// Least spread of chrominance as a share of the spread of luminance: the chrominance of grey light is rounding.
#define QUELL_CHANGE_LEAST_CHROMINANCE 1e-4f

#endif

// Parameters of the stage atrous.
#ifndef QUELL_ATROUS_PARAMS_H
#define QUELL_ATROUS_PARAMS_H

#include "common/edge_stops_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct AtrousParams {
  PlaneParams planes;
  EdgeStopParams stops;
  QuellFloat luminanceSigma;  // in standard deviations, or in units of luminance without variance
  QuellFloat inverseStep;
  QuellFloat sharpening;  // 1: the stop on luminance narrows below the roughness that follows, 0: nowhere
  QuellFloat inverseSharpRoughness;  // 1 / that roughness
  QuellInt step;                     // pixels between taps
  QuellInt iteration;                // from 1 on; only with SKIP
  QuellInt corners;                  // 1: all taps, 0: without the four corners
  QuellInt filtersVariance;          // 1: variance is written, too; only with VARIANCE
} AtrousParams;

QUELL_NAMESPACE_END

// Added to the tolerated difference in luminance, so that it is never 0 (luminance).
#define QUELL_LEAST_LUMINANCE_STEP 1e-10f

#endif

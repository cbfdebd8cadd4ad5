// Parameters of the stage sparse_bilateral.
#ifndef QUELL_SPARSE_BILATERAL_PARAMS_H
#define QUELL_SPARSE_BILATERAL_PARAMS_H

#include "common/edge_stops_params.h"
#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct SparseBilateralParams {
  PlaneParams planes;
  PlaneParams cells;  // only with CELL_RADIUS: the grid of low_confidence
  EdgeStopParams stops;
  QuellFloat radius;  // pixels, at most QUELL_SPARSE_MOST_RADIUS; with CELL_RADIUS where nothing is trusted
  QuellFloat
      lowFactor;    // only with CELL_RADIUS: the radius is that many times larger where confidence is low
  QuellInt cosine;  // of the angle by which the pattern is turned in this frame, times QUELL_SUNFLOWER_UNIT
  QuellInt sine;
} SparseBilateralParams;

QUELL_NAMESPACE_END

// Radii are whole numbers of this share of a pixel.
#define QUELL_SPARSE_STEPS 16
// Larger ones are cut: the products of whole numbers that place taps fit into 32 bits.
#define QUELL_SPARSE_MOST_RADIUS 4096.0f
// Confidence below which the radius grows by a factor (Mara et al. 2017, section 3.4).
#define QUELL_LOW_CONFIDENCE 0.5f

#endif

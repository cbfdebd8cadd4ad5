// Parameters of the stage classify.
#ifndef QUELL_CLASSIFY_PARAMS_H
#define QUELL_CLASSIFY_PARAMS_H

#include "common/types.h"

QUELL_NAMESPACE_BEGIN

typedef struct ClassifyParams {
  PlaneParams planes;
  QuellInt tilesX;
  QuellInt tilesY;
  QuellInt iterations;   // of the filter
  QuellFloat tolerance;  // noise that may stay, standard deviations of display-encoded values
} ClassifyParams;

QUELL_NAMESPACE_END

// What is left of the standard deviation of independent noise after one iteration: the root of the sum of squared
// weights, of the 5x5 B3 spline of the first iteration, and of a later one, which doubles the filter's width.
#define QUELL_FIRST_ITERATION_NOISE 0.273f
#define QUELL_LATER_ITERATION_NOISE 0.5f

#endif

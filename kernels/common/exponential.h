// Weights of filter taps in place of e^-v: a library exp stays a call on some CPU runtimes and costs more than the rest of a
// tap, and a series for it is still a third of that.
#ifndef QUELL_COMMON_EXPONENTIAL_H
#define QUELL_COMMON_EXPONENTIAL_H

#include "common/lanes.h"

// (1 - v / 9)^8 differs from e^-v by at most .0271, both ways; from 9 on it is 0. Its square is a denormal, which are slow
// on many CPUs, in the last 250th of that alone.
#define QUELL_LARGEST_PENALTY 9.0f
// A sum of weights up to this is none: its inverse, squared, is still finite.
#define QUELL_LEAST_WEIGHT_SUM 1e-18f

// For v >= 0; 0 for NaN.
QUELL_INLINE floatL weightOfPenalty(floatL v) {
  const floatL root = maxLanes(1.0f - v * (1.0f / QUELL_LARGEST_PENALTY), ZERO_LANES);
  const floatL square = root * root;
  const floatL fourth = square * square;
  return fourth * fourth;
}

#endif

// e^-v for filter weights: a library exp stays a call on some CPU runtimes and costs more than the rest of a tap.
#ifndef QUELL_COMMON_EXPONENTIAL_H
#define QUELL_COMMON_EXPONENTIAL_H

#include "common/lanes.h"

// Adding it to a float below 2^22 rounds that to a whole number, which then sits in the low bits (1.5 * 2^23).
#define QUELL_ROUNDING_SHIFT 12582912.0f
// From here on e^-v counts as 0. Its square must stay far above the denormals, which are slow on many CPUs.
#define QUELL_LARGEST_PENALTY 20.0f

// e^-v for v >= 0; 0 from QUELL_LARGEST_PENALTY on and for NaN. 2^f for f in [-0.5, 0.5] from its Taylor series up to
// f^5, of which f^5 is economised (Chebyshev): relative error below 1e-5.
QUELL_INLINE floatL weightOfPenalty(floatL v) {
  const floatL shifted = v * -1.44269504f + QUELL_ROUNDING_SHIFT;
  const floatL f = v * -1.44269504f - (shifted - QUELL_ROUNDING_SHIFT);
  const floatL series =
      1.0f + f * (0.693121139f + f * (0.240226507f + f * (0.0559207824f + f * 0.00961812911f)));
  const floatL power = AS_FLOAT(AS_INT(series) + (AS_INT(shifted) << 23));
  return v < QUELL_LARGEST_PENALTY ? power : ZERO_LANES;
}

#endif

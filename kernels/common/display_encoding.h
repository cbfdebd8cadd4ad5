// Display encoding: clamp to [0, 1] and gamma 2.2, as the reference implementation of Koskela et al. 2019 tone maps.
//
// x^(1/2.2) = 2^(log2(x) / 2.2), both from short series: a library pow costs more than the rest of the stage on CPUs.
// Largest absolute error of encodeDisplay over [0, 1]: kEncodingTolerance in tests/oracle/display_encoding_oracle.hpp, a
// 1000th of a step of 8 bits.
#ifndef QUELL_COMMON_DISPLAY_ENCODING_H
#define QUELL_COMMON_DISPLAY_ENCODING_H

#include "common/exponential.h"
#include "common/lanes.h"

#define QUELL_DISPLAY_GAMMA 2.2f

// log2 for normal positive v: v = 2^e (1 + f) with 1 + f in [sqrt(1/2), sqrt(2)); log2(1 + f) / f is the polynomial that
// agrees with it at six Chebyshev nodes. Off by less than 5e-6.
QUELL_INLINE floatL log2Lanes(floatL v) {
  const intL bits = AS_INT(v) - 0x3f3504f3;  // exponent steps at sqrt(1/2) instead of at 1
  const intL exponent = bits >> 23;
  const floatL f = AS_FLOAT((bits & 0x007fffff) + 0x3f3504f3) - 1.0f;
  const floatL high = -0.366925771f + f * (0.316898187f + f * -0.202289264f);
  const floatL series = 1.44270044f + f * (-0.721195752f + f * (0.479925573f + f * high));
  return TO_FLOAT(exponent) + f * series;
}

// 2^v for v in [-126, 126]: 2^f for f in [-0.5, 0.5] is the polynomial that agrees with it at five Chebyshev nodes.
// Relative error below 4e-6.
QUELL_INLINE floatL exp2Lanes(floatL v) {
  const floatL shifted = v + QUELL_ROUNDING_SHIFT;
  const floatL f = v - (shifted - QUELL_ROUNDING_SHIFT);
  const floatL series =
      1.0f + f * (0.693121045f + f * (0.240223490f + f * (0.0559219758f + f * 0.00966636852f)));
  return AS_FLOAT(AS_INT(series) + (AS_INT(shifted) << 23));
}

// Values below this encode to 0 (2^-100): it keeps the logarithm off zero and denormals.
#define QUELL_DISPLAY_LEAST 7.8886090522101181e-31f

QUELL_INLINE floatL encodeDisplay(floatL linear) {
  const floatL v = clampLanes(linear, QUELL_DISPLAY_LEAST, 1.0f);
  const floatL encoded = exp2Lanes(log2Lanes(v) * (1.0f / QUELL_DISPLAY_GAMMA));
  return v > QUELL_DISPLAY_LEAST ? encoded : ZERO_LANES;
}

QUELL_INLINE float3L encodeDisplay3(float3L linear) {
  linear.x = encodeDisplay(linear.x);
  linear.y = encodeDisplay(linear.y);
  linear.z = encodeDisplay(linear.z);
  return linear;
}

#endif

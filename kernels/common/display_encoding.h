// Display encoding: clamp to [0, 1] and gamma 2.2, as the reference implementation of Koskela et al. 2019 tone maps.
//
// x^(1/2.2) = 2^(log2(x) / 2.2), both from short series: a library pow costs more than the rest of the stage on CPUs.
// Largest absolute error of encodeDisplay over [0, 1]: kEncodingTolerance in tests/oracle/display_encoding_oracle.hpp.
#ifndef QUELL_COMMON_DISPLAY_ENCODING_H
#define QUELL_COMMON_DISPLAY_ENCODING_H

#include "common/lanes.h"

#define QUELL_DISPLAY_GAMMA 2.2f

// log2 for normal positive v: v = 2^e (1 + f) with 1 + f in [sqrt(1/2), sqrt(2)); log2(1 + f) / f is the polynomial that
// agrees with it at eight Chebyshev nodes. Off by less than 1e-7.
QUELL_INLINE floatL log2Lanes(floatL v) {
  const intL bits = AS_INT(v) - 0x3f3504f3;  // exponent steps at sqrt(1/2) instead of at 1
  const intL exponent = bits >> 23;
  const floatL f = AS_FLOAT((bits & 0x007fffff) + 0x3f3504f3) - 1.0f;
  const floatL high = 0.287288882f + f * (-0.249271822f + f * (0.232652579f + f * -0.142759734f));
  const floatL series =
      1.44269499f + f * (-0.721352931f + f * (0.480916708f + f * (-0.360225182f + f * high)));
  return TO_FLOAT(exponent) + f * series;
}

// 2^v for v in [-126, 126]: Taylor series of e^(f ln 2) for f in [-0.5, 0.5], first dropped term below 6e-9.
QUELL_INLINE floatL exp2Lanes(floatL v) {
  const intL whole = floorLanes(v + 0.5f);
  const floatL y = (v - TO_FLOAT(whole)) * 0.693147181f;
  const floatL series =
      1.0f +
      y * (1.0f + y * (0.5f + y * (0.166666667f +
                                   y * (0.0416666667f +
                                        y * (0.00833333333f + y * (0.00138888889f + y * 0.000198412698f))))));
  return series * AS_FLOAT((whole + 127) << 23);
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

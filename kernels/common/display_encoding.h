// Display encoding: clamp to [0, 1] and gamma 2.2, as the reference implementation of Koskela et al. 2019 tone maps.
//
// x^(1/2.2) = 2^(log2(x) / 2.2), both from short series: a library pow costs more than the rest of the stage on CPUs.
// Largest absolute error of encodeDisplay over [0, 1]: kToneMapTolerance in tests/cases/tone_map_case.hpp.
#ifndef QUELL_COMMON_DISPLAY_ENCODING_H
#define QUELL_COMMON_DISPLAY_ENCODING_H

#include "common/lanes.h"

#define QUELL_DISPLAY_GAMMA 2.2f

// log2 for normal positive v: v = 2^e m with m in [sqrt(1/2), sqrt(2)); log2(m) from the series of
// 2 artanh((m - 1) / (m + 1)), whose first dropped term is below 1e-9.
QUELL_INLINE floatL log2Lanes(floatL v) {
  const intL bits = AS_INT(v) - 0x3f3504f3;  // exponent steps at sqrt(1/2) instead of at 1
  const intL exponent = bits >> 23;
  const floatL m = AS_FLOAT((bits & 0x007fffff) + 0x3f3504f3);
  const floatL t = (m - 1.0f) / (m + 1.0f);
  const floatL t2 = t * t;
  // 2 / ln(2) times 1, 1/3, 1/5, 1/7, 1/9
  const floatL series =
      2.88539008f + t2 * (0.961796694f + t2 * (0.577078016f + t2 * (0.412198583f + t2 * 0.320598898f)));
  return TO_FLOAT(exponent) + t * series;
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

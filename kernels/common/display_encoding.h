// From radiance to the display image: exposure, tone map (TONE_MAP) and encoding (DISPLAY_ENCODING, see
// common/display_modes.h).
//
// Tone maps: clamp to [0, 1], as the reference implementation of Koskela et al. 2019 does; Reinhard et al. 2002, equation 3,
// on luminance; the curve that Narkowicz 2015 fitted to ACES, per channel; none, up to QUELL_MAX_RADIANCE.
// Encodings: gamma 2.2, as in that reference implementation; sRGB (IEC 61966-2-1); linear, as it is.
//
// Powers x^p = 2^(p log2(x)) are made of two short series: a library pow costs more than the rest of the stage on CPUs.
// Largest errors: kEncodingTolerance in tests/oracle/display_encoding_oracle.hpp, a 1000th of a step of 8 bits.
#ifndef QUELL_COMMON_DISPLAY_ENCODING_H
#define QUELL_COMMON_DISPLAY_ENCODING_H

#include "common/display_modes.h"
#include "common/exponential.h"
#include "common/lanes.h"
#include "common/luminance.h"
#include "common/types.h"

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

// Adding it to a float below 2^22 rounds that to a whole number, which then sits in the low bits (1.5 * 2^23).
#define QUELL_ROUNDING_SHIFT 12582912.0f

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
// What a tone map leaves.
#if TONE_MAP == QUELL_TONE_MAP_NONE
#define QUELL_DISPLAY_MOST QUELL_MAX_RADIANCE
#else
#define QUELL_DISPLAY_MOST 1.0f
#endif

QUELL_INLINE floatL power(floatL v, float exponent) {
  const floatL raised = exp2Lanes(log2Lanes(v) * exponent);
  return v > QUELL_DISPLAY_LEAST ? raised : ZERO_LANES;
}

QUELL_INLINE floatL encodeGamma(floatL v) { return power(v, 1.0f / QUELL_DISPLAY_GAMMA); }

QUELL_INLINE floatL encodeSrgb(floatL v) {
  return v <= 0.0031308f ? 12.92f * v : 1.055f * power(v, 1.0f / 2.4f) - 0.055f;
}

// Narkowicz 2015. Passes 1 at about 7; clamped afterwards.
QUELL_INLINE floatL acesCurve(floatL v) {
  return (v * (2.51f * v + 0.03f)) / (v * (2.43f * v + 0.59f) + 0.14f);
}

// Of radiance times exposure. What a ratio is made of stays finite, and so do its squares.
QUELL_INLINE float3L toneMap(float3L exposed) {
#if TONE_MAP == QUELL_TONE_MAP_REINHARD
  exposed = clamp3(exposed, 0.0f, QUELL_MAX_RADIANCE);
  return scale3(exposed, 1.0f / (1.0f + luminance(exposed)));
#elif TONE_MAP == QUELL_TONE_MAP_ACES
  exposed = clamp3(exposed, 0.0f, QUELL_MAX_RADIANCE);
  exposed.x = acesCurve(exposed.x);
  exposed.y = acesCurve(exposed.y);
  exposed.z = acesCurve(exposed.z);
#endif
  return exposed;
}

QUELL_INLINE floatL encodeChannel(floatL mapped) {
  const floatL v = clampLanes(mapped, QUELL_DISPLAY_LEAST, QUELL_DISPLAY_MOST);
#if DISPLAY_ENCODING == QUELL_ENCODING_SRGB
  return encodeSrgb(v);
#elif DISPLAY_ENCODING == QUELL_ENCODING_LINEAR
  return v > QUELL_DISPLAY_LEAST ? v : ZERO_LANES;
#else
  return encodeGamma(v);
#endif
}

// `exposure`: factor of radiance.
QUELL_INLINE float3L encodeDisplay(float3L radiance, float exposure) {
  float3L shown = toneMap(scale3(radiance, (floatL)(exposure)));
  shown.x = encodeChannel(shown.x);
  shown.y = encodeChannel(shown.y);
  shown.z = encodeChannel(shown.z);
  return shown;
}

#endif

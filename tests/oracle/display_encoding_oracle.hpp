// Double-precision oracle of the display encoding, see kernels/common/display_encoding.h.
#pragma once

#include <algorithm>
#include <cmath>

namespace quell::tests {

/// Largest absolute error of the encoding over [0, 1]. Results near 1 have the largest: rounding of a result below 1
/// (6e-8) and of an exponent below 1/2 in magnitude (2e-8), with room for compilers that divide less exactly.
constexpr double kEncodingTolerance = 3e-7;

/// Clamp to [0, 1] and gamma 2.2 (Koskela et al. 2019, reference implementation); what is not a number counts as 0.
inline double encodeDisplayExact(double linear) {
  constexpr double kDisplayGamma = 2.2;
  if (std::isnan(linear)) return 0.0;
  return std::pow(std::clamp(linear, 0.0, 1.0), 1.0 / kDisplayGamma);
}

}  // namespace quell::tests

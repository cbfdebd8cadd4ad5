// Double-precision oracle of the display encoding, see kernels/common/display_encoding.h.
#pragma once

#include <algorithm>
#include <cmath>

namespace quell::tests {

/// Largest absolute error of the encoding over [0, 1], a 1000th of a step of 8 bits, with room for compilers that divide
/// less exactly: the power is off by less than 4e-6, the logarithm by 5e-6 of which ln 2 / 2.2 arrives (3e-6 measured).
constexpr double kEncodingTolerance = 4e-6;

/// The unit of encoded values where errors may be as large as this in linear ones, which the encoding halves.
constexpr double displayUnit(double tolerance) { return 1.0 + kEncodingTolerance / tolerance; }

/// Clamp to [0, 1] and gamma 2.2 (Koskela et al. 2019, reference implementation); what is not a number counts as 0.
inline double encodeDisplayExact(double linear) {
  constexpr double kDisplayGamma = 2.2;
  if (std::isnan(linear)) return 0.0;
  return std::pow(std::clamp(linear, 0.0, 1.0), 1.0 / kDisplayGamma);
}

}  // namespace quell::tests

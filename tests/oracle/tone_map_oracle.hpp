// Double-precision oracle of the stage tone_map, see kernels/tone_map.cl.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

/// Clamp to [0, 1] and gamma 2.2; what is not a number counts as 0.
double encodeDisplayExact(double linear);

ExactPlanes toneMapOracle(const Planes& linear);

}  // namespace quell::tests

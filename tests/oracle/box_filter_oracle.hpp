// Double-precision oracle of the stage box_filter, see kernels/box_filter.cl.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

struct BoxFilterExact {
  ExactPlanes sums;
  ExactPlanes magnitudes;  ///< of the terms without their signs
};

/// Sums over `radius` neighbours to either side, in rows or in columns.
BoxFilterExact boxFilterOracle(const Planes& planes, int radius, bool alongRows);

}  // namespace quell::tests

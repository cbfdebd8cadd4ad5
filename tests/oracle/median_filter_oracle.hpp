// Oracle of the stage median_filter (Mara et al. 2017, stage 6), see kernels/median_filter.cl.
#pragma once

#include "tests/support/planes.hpp"

namespace quell::tests {

/// Medians of 3x3 pixels of every plane; the centre stands for those without a weight and those outside.
ExactPlanes medianFilterOracle(const Planes& planes, const Planes& weights);

}  // namespace quell::tests

// What the cases of a fit's stages share.
#pragma once

#include "kernels/common/types.h"
#include "tests/oracle/feature_oracle.hpp"

namespace quell::tests {

/// Guides with four planes of random albedo and roughness behind them, 0 to 1.
Planes withMaterials(const Planes& guides, unsigned seed);

/// Records of random coefficients and scalings.
Planes randomRecords(const FeatureNames& list, int count, unsigned seed);

QuellFloat4 viewAxisOf(const FeatureNames& list);

}  // namespace quell::tests

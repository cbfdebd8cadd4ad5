// What the cases of a guided filter's stages have in common.
#pragma once

#include "tests/cases/filter_inputs.hpp"
#include "tests/oracle/guided_moments_oracle.hpp"

namespace quell::tests {

/// Settings of the filter other than the defaults.
struct GuidedVariant {
  int subsampling = 4;  ///< pixels
  int signals = 1;
};

constexpr double kGuidedEpsilon = 0.02;
constexpr int kGuidedRadius = 9;  // pixels

StageSetup makeGuidedSetup(const CaseOptions& options, const GuidedVariant& variant);

/// Of windows, in cells.
int guidedCellRadius(int subsampling);

/// Random irradiance with edges where normals turn, over the scene of filter_inputs.hpp.
GuidedMomentsInputs guidedPixels(const CaseOptions& options, const GuidedVariant& variant);

}  // namespace quell::tests

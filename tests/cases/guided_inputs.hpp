// What the cases of a guided filter's stages have in common.
#pragma once

#include "tests/cases/filter_inputs.hpp"

namespace quell::tests {

/// Settings of the filter other than the defaults.
struct GuidedVariant {
  int subsampling = 4;  ///< pixels
  int signals = 1;
};

constexpr double kGuidedEpsilon = 0.02;
constexpr int kGuidedRadius = 9;  // pixels

StageSetup makeGuidedSetup(const CaseOptions& options, const GuidedVariant& variant);

/// Random irradiance with edges where normals turn, as a filter finds it.
Planes guidedIrradiance(const FilterGuides& guides, const CaseOptions& options, int signals);

}  // namespace quell::tests

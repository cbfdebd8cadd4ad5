// Guides of an image with edges, for the cases of variance and atrous.
#pragma once

#include "tests/cases/stage_case.hpp"
#include "tests/oracle/edge_stops_oracle.hpp"

namespace quell::tests {

/// Which signals and images the caller has.
struct FilterVariant {
  int signals = 1;
  bool roughness = false;  ///< with a stop at it
};

/// The caller's images of the variant, and settings of this method other than the defaults: a mixed-up one shows.
void setFilterMethod(StageSetup& setup, const std::string& method, const FilterVariant& variant);

/// Of the settings: what the kernels get.
EdgeStopParams edgeStopsOf(const Settings& settings);

/// The test scene, tilted and roughened so that penalties of all sizes occur; holes, and weights below 1 where a
/// material fades out.
FilterGuides randomGuides(const FilterVariant& variant, const CaseOptions& options);

/// Sends what the stage's line of the table names.
void uploadGuides(StageHarness& harness, const FilterGuides& guides);

}  // namespace quell::tests

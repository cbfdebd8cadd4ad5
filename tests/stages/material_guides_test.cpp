#include "kernels/fit_params.h"
#include "tests/cases/material_guides_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

TEST_CASE("material_guides agrees with its oracle") {
  checkSizes([](const CaseOptions& options) { return std::make_unique<MaterialGuidesCase>(options); });
}

TEST_CASE("material_guides reads every layout") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const ImageLayout& layout : inputLayouts()) {
      if (layout.channels == 2) continue;  // not an albedo
      CaseOptions options;
      options.mapping = mapping;
      options.layout = layout;
      MaterialGuidesCase guides(options);
      checkAgreement(guides, options);
    }
  }
}

TEST_CASE("material_guides takes what is not finite for 0") {
  for (const CaseOptions& options : bothMappings()) {
    MaterialGuidesCase guides(options);
    spoil(guides.inputs.albedo, 3, 5);
    spoil(guides.inputs.roughness, 4, 5);
    checkAgreement(guides, options);
    for (const float value : guides.materials().values) CHECK((value >= 0.0f && value <= 1.0f));
  }
}

TEST_CASE("material_guides does not depend on the work-group") {
  checkWorkGroups([](const CaseOptions& options) { return std::make_unique<MaterialGuidesCase>(options); },
                  {"materials"});
}

#include "tests/cases/separable_bilateral_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(bool alongRows, bool roughness = true) {
  return [=](const CaseOptions& options) {
    return std::make_unique<SeparableBilateralCase>(options, alongRows, roughness);
  };
}

}  // namespace

TEST_CASE("separable_bilateral in columns agrees with its oracle") { checkSizes(maker(false)); }

TEST_CASE("separable_bilateral in rows, with and without roughness, agrees with its oracle") {
  checkVariants({maker(false, false), maker(true, false), maker(true)});
}

TEST_CASE("separable_bilateral leaves out background") { checkHoles(maker(true)); }

TEST_CASE("separable_bilateral does not depend on the work-group") {
  checkWorkGroups(maker(true), {"separableOutput"});
}

TEST_CASE("separable_bilateral leaves a mirror sharp") {
  for (const CaseOptions& options : bothMappings()) {
    SeparableBilateralCase mirror(options, true);
    fill(mirror.inputs.guides.roughness, 0.0f);
    fill(mirror.inputs.guides.guides, 1.0f);
    mirror.uploadAndRun();
    CHECK(sameBits(mirror.filtered(), mirror.inputs.irradiance));
  }
}

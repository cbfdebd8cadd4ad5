#include "tests/cases/guided_moments_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(const GuidedVariant& variant) {
  return [=](const CaseOptions& options) { return std::make_unique<GuidedMomentsCase>(options, variant); };
}

}  // namespace

TEST_CASE("guided_moments agrees with its oracle") { checkSizes(maker({})); }

TEST_CASE("guided_moments of cells of any size agrees with its oracle") {
  checkVariants({maker({1, 1}), maker({2, 1}), maker({8, 1})});
}

TEST_CASE("guided_moments of two signals agrees with its oracle and leaves out background") {
  checkHoles(maker({4, 2}));
  checkHoles(maker({1, 2}));
}

TEST_CASE("guided_moments does not depend on the work-group") {
  for (CaseOptions options : bothMappings({77, 43})) {
    GuidedMomentsCase usual(options);
    usual.uploadAndRun();
    options.workGroup = {16, 4};
    GuidedMomentsCase other(options);
    other.uploadAndRun();
    CHECK(sameBits(usual.moments(), other.moments()));
  }
}

TEST_CASE("guided_moments of pixels that are not there are 0") {
  for (CaseOptions options : bothMappings({37, 5})) {
    GuidedMomentsCase empty(options);
    forEachPixel(options.size,
                 [&](int x, int y) { empty.inputs.guides.at(QUELL_GUIDE_WEIGHT, x, y) = 0.0f; });
    empty.uploadAndRun();
    const Planes moments = empty.moments();
    CHECK(sameBits(moments, Planes(moments.size(), moments.count)));
  }
}

TEST_CASE("guided_moments of the largest depths are finite") {
  for (CaseOptions options : bothMappings({37, 5})) {
    GuidedMomentsCase far(options);
    for (float& depth : far.inputs.viewDepth.values) depth = depth > 4.0f ? 3e38f : -3e38f;
    fill(far.inputs.irradiance, QUELL_MAX_RADIANCE);
    far.uploadAndRun();
    CHECK(allFinite(far.moments()));
  }
}

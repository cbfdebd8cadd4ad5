#include "tests/cases/guided_evaluate_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(const GuidedVariant& variant) {
  return [=](const CaseOptions& options) { return std::make_unique<GuidedEvaluateCase>(options, variant); };
}

}  // namespace

TEST_CASE("guided_evaluate agrees with its oracle") { checkSizes(maker({})); }

TEST_CASE("guided_evaluate of cells of any size agrees with its oracle") {
  checkVariants({maker({1, 1}), maker({2, 1}), maker({8, 1})});
}

TEST_CASE("guided_evaluate of two signals agrees with its oracle and leaves out background") {
  checkHoles(maker({4, 2}));
}

TEST_CASE("guided_evaluate does not depend on the work-group") {
  checkWorkGroups(maker({4, 1}), {"guidedIrradiance"});
}

TEST_CASE("guided_evaluate is 0 where no window had a sample, and never negative") {
  for (CaseOptions options : bothMappings()) {
    GuidedEvaluateCase none(options);
    fill(none.inputs.windowCoefficients, 0.0f);
    none.uploadAndRun();
    CHECK(sameBits(none.irradiance(), Planes(options.size, 3)));
    GuidedEvaluateCase negative(options);
    Planes& coefficients = negative.inputs.windowCoefficients;
    fill(coefficients, 0.0f);
    forEachPixel(coefficients.size(), [&](int x, int y) {
      coefficients.at(0, x, y) = -1.0f;
      coefficients.at(QUELL_GUIDED_USED, x, y) = 1.0f;
    });
    negative.uploadAndRun();
    for (const float value : negative.irradiance().values) CHECK(value == 0.0f);
  }
}

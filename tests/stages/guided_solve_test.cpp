#include "tests/cases/guided_solve_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(const GuidedVariant& variant) {
  return [=](const CaseOptions& options) { return std::make_unique<GuidedSolveCase>(options, variant); };
}

}  // namespace

TEST_CASE("guided_solve agrees with its oracle") { checkSizes(maker({})); }

TEST_CASE("guided_solve of cells of any size agrees with its oracle") {
  checkVariants({maker({1, 1}), maker({2, 1}), maker({8, 1})});
}

TEST_CASE("guided_solve of two signals agrees with its oracle and does not depend on the work-group") {
  for (CaseOptions options : bothMappings({77, 43})) {
    GuidedSolveCase usual(options, {2, 2});
    checkAgreement(usual, options);
    options.workGroup = {16, 4};
    GuidedSolveCase other(options, {2, 2});
    usual.uploadAndRun();
    other.uploadAndRun();
    CHECK(sameBits(usual.coefficients(), other.coefficients()));
  }
}

TEST_CASE("guided_solve of a constant is the constant") {
  for (CaseOptions options : bothMappings()) {
    GuidedSolveCase constant(options);
    fill(constant.pixels.irradiance, 3.25f);
    constant.uploadAndRun();
    const Planes coefficients = constant.coefficients();
    forEachPixel(coefficients.size(), [&](int x, int y) {
      if (coefficients.at(QUELL_GUIDED_USED, x, y) == 0.0f) return;
      for (int k = 0; k < QUELL_GUIDED_USED; ++k)
        CHECK(coefficients.at(k, x, y) == Approx(k < QUELL_GUIDED_CHANNELS ? 3.25 : 0.0).margin(2e-4));
    });
  }
}

TEST_CASE("guided_solve says the same in scenes of any unit") {
  for (CaseOptions options : bothMappings()) {
    GuidedSolveCase small(options), large(options);
    constexpr float kUnit = 1024.0f;  // a power of two: the same digits
    for (float& depth : large.pixels.viewDepth.values) depth *= kUnit;
    small.uploadAndRun();
    large.uploadAndRun();
    Planes scaled = large.coefficients();
    for (int c = 0; c < QUELL_GUIDED_CHANNELS; ++c)
      forEachPixel(scaled.size(), [&](int x, int y) {
        scaled.at(QUELL_GUIDED_DEPTH * QUELL_GUIDED_CHANNELS + c, x, y) *= kUnit;
      });
    CHECK(sameBits(small.coefficients(), scaled));
  }
}

TEST_CASE("guided_solve of extreme depths is finite") {
  for (CaseOptions options : bothMappings({37, 5})) {
    for (const float depth : {0.0f, 1e-30f, 1e15f, -1e15f}) {
      GuidedSolveCase extreme(options);
      for (float& value : extreme.pixels.viewDepth.values) value = value > 4.0f ? depth : depth / 2.0f;
      fill(extreme.pixels.irradiance, QUELL_MAX_RADIANCE);
      extreme.uploadAndRun();
      CHECK(allFinite(extreme.coefficients()));
    }
  }
}

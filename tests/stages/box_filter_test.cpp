#include "kernels/guided_params.h"
#include "tests/cases/box_filter_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(BoxPass pass, const GuidedVariant& variant) {
  return [=](const CaseOptions& options) { return std::make_unique<BoxFilterCase>(options, pass, variant); };
}

}  // namespace

TEST_CASE("box_filter along rows agrees with its oracle") { checkSizes(maker(BoxPass::MomentRows, {4, 1})); }

TEST_CASE("box_filter along columns agrees with its oracle") {
  checkSizes(maker(BoxPass::MomentColumns, {4, 1}));
}

TEST_CASE("box_filter of every pass and any cells agrees with its oracle") {
  checkVariants({maker(BoxPass::CoefficientColumns, {1, 1}), maker(BoxPass::CoefficientRows, {1, 2}),
                 maker(BoxPass::MomentRows, {8, 2}), maker(BoxPass::MomentColumns, {2, 1})});
}

TEST_CASE("box_filter does not depend on the work-group") {
  const auto sumsOf = [](const CaseOptions& options) {
    BoxFilterCase box(options);
    box.uploadAndRun();
    return box.sums();
  };
  CaseOptions options;
  options.size = {77, 43};
  const Planes usual = sumsOf(options);
  options.workGroup = {16, 4};
  CHECK(sameBits(usual, sumsOf(options)));
  options.mapping = Mapping::Narrow;
  CHECK(sameBits(usual, sumsOf(options)));
}

TEST_CASE("box_filter counts the cells of a window") {
  for (CaseOptions options : bothMappings({200, 3})) {
    BoxFilterCase box(options, BoxPass::MomentRows, {1, 1});
    fill(box.input, 1.0f);
    box.uploadAndRun();
    const Planes sums = box.sums();
    CHECK(sums.at(0, 0, 0) == float(kGuidedRadius + 1));
    CHECK(sums.at(0, 100, 1) == float(2 * kGuidedRadius + 1));
    CHECK(sums.at(QUELL_GUIDED_SUMS - 1, 199, 2) == float(kGuidedRadius + 1));
  }
}

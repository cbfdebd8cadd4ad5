#include <algorithm>
#include <limits>

#include "kernels/accumulate_noisy_params.h"
#include "tests/cases/blended_sum_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

constexpr GramWindows kOverlaps[] = {kOverlap8, kOverlap16};

std::string describe(const GramWindows& windows) { return "tiles of " + std::to_string(windows.tileEdge); }

CaseMaker maker(const GramWindows& windows) {
  return [windows](const CaseOptions& options) -> std::unique_ptr<StageCase> {
    return std::make_unique<BlendedSumCase>(options, windows);
  };
}

CaseOptions makeOptions(Size size, Mapping mapping) {
  CaseOptions options;
  options.size = size;
  options.mapping = mapping;
  return options;
}

}  // namespace

TEST_CASE("blended_sum agrees with its oracle") {
  for (const GramWindows& windows : kOverlaps) {
    INFO(describe(windows));
    checkSizes(maker(windows));
  }
}

// Sizes around one and two tiles: windows whose centre lies outside are replaced, but for the last one left.
TEST_CASE("blended_sum agrees with its oracle at all offsets of the grid") {
  for (const GramWindows& windows : kOverlaps) {
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      for (const Size size : {Size{65, 34}, Size{7, 9}, Size{3, 17}}) {
        const CaseOptions options = makeOptions(size, mapping);
        BlendedSumCase blended(options, windows);
        for (std::uint32_t frame = 0; frame < 16; ++frame) {
          blended.useFrame(frame);
          INFO(describe(windows) << ", frame " << frame);
          checkAgreement(blended, options);
        }
      }
    }
  }
}

TEST_CASE("blended_sum leaves out background") { checkHoles(maker(kOverlap8)); }

TEST_CASE("blended_sum does not depend on the work-group") {
  for (const GramWindows& windows : kOverlaps) {
    INFO(describe(windows));
    checkWorkGroups(maker(windows), {"fitted"});
  }
}

TEST_CASE("blended_sum of the same fit everywhere is that fit") {
  for (const GramWindows& windows : kOverlaps) {
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      BlendedSumCase blended(makeOptions({77, 43}, mapping), windows);
      FitRecord record;
      record.coefficients.row(0).setConstant(3.25);
      blended.inputs.records = packRecords(
          std::vector<FitRecord>(blended.inputs.records.values.size() / QUELL_FIT_RECORD, record));
      blended.uploadAndRun();
      const Planes fitted = blended.fitted();
      Comparison comparison;
      forEachPixel(fitted.size(), [&](int x, int y) {
        bool surface = false;
        for (int axis = 0; axis < 3; ++axis)
          surface = surface || blended.inputs.guides.at(QUELL_GUIDE_NORMAL + axis, x, y) != 0.0f;
        comparison.include("fitted", 0, x, y, fitted.at(0, x, y), surface ? 3.25 : 0.0);
      });
      INFO(comparison.worst());
      CHECK(comparison.largestError() <= kBlendedSumTolerance);
    }
  }
}

TEST_CASE("blended_sum is 0 on background and where a fit broke") {
  BlendedSumCase blended({});
  std::fill(blended.inputs.records.values.begin(), blended.inputs.records.values.end(),
            std::numeric_limits<float>::quiet_NaN());
  blended.uploadAndRun();
  for (const float value : blended.fitted().values) CHECK(value == 0.0f);
}

TEST_CASE("blended_sum clamps to non-negative, finite halves") {
  BlendedSumCase blended({});
  for (float& value : blended.inputs.records.values) value *= 1e30f;
  blended.uploadAndRun();
  for (const float value : blended.fitted().values) {
    CHECK(value >= 0.0f);
    CHECK(value <= QUELL_MAX_RADIANCE);
  }
}

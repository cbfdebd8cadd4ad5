#include <algorithm>
#include <limits>

#include "kernels/accumulate_noisy_params.h"
#include "tests/cases/weighted_sum_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

std::unique_ptr<StageCase> make(const CaseOptions& options) {
  return std::make_unique<WeightedSumCase>(options);
}

}  // namespace

TEST_CASE("weighted_sum agrees with its oracle") { checkSizes(make); }

TEST_CASE("weighted_sum agrees with its oracle at all offsets of the grid") {
  for (const CaseOptions& options : bothMappings({65, 34})) {
    WeightedSumCase weightedSum(options);
    for (std::uint32_t frame = 0; frame < 16; ++frame) {
      weightedSum.useFrame(frame);
      INFO("frame " << frame);
      checkAgreement(weightedSum, options);
    }
  }
}

TEST_CASE("weighted_sum leaves out background") { checkHoles(make); }

TEST_CASE("weighted_sum does not depend on the work-group") { checkWorkGroups(make, {"fitted"}); }

TEST_CASE("weighted_sum is 0 on background and where a fit broke") {
  WeightedSumCase weightedSum({});
  std::fill(weightedSum.inputs.records.values.begin(), weightedSum.inputs.records.values.end(),
            std::numeric_limits<float>::quiet_NaN());
  weightedSum.uploadAndRun();
  for (const float value : weightedSum.fitted().values) CHECK(value == 0.0f);
}

TEST_CASE("weighted_sum clamps to non-negative, finite halves") {
  WeightedSumCase weightedSum({});
  for (float& value : weightedSum.inputs.records.values) value *= 1e30f;
  weightedSum.uploadAndRun();
  for (const float value : weightedSum.fitted().values) {
    CHECK(value >= 0.0f);
    CHECK(value <= QUELL_MAX_RADIANCE);
  }
}

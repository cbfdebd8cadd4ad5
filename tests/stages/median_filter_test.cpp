#include "tests/cases/median_filter_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

std::unique_ptr<StageCase> make(const CaseOptions& options) {
  return std::make_unique<MedianFilterCase>(options);
}

}  // namespace

TEST_CASE("median_filter agrees with its oracle") { checkSizes(make); }

TEST_CASE("median_filter leaves out background") { checkHoles(make); }

TEST_CASE("median_filter takes a firefly out") {
  for (const CaseOptions& options : bothMappings()) {
    MedianFilterCase firefly(options);
    fill(firefly.irradiance, 0.5f);
    fill(firefly.guides, 1.0f);
    firefly.irradiance.at(1, 16, 15) = 1000.0f;
    firefly.uploadAndRun();
    for (const float value : firefly.medians().values) CHECK(value == 0.5f);
  }
}

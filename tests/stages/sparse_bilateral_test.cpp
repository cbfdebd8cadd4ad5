#include <cmath>

#include "kernels/common/sunflower.h"
#include "tests/cases/sparse_bilateral_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(bool followsConfidence) {
  return [=](const CaseOptions& options) {
    return std::make_unique<SparseBilateralCase>(options, followsConfidence);
  };
}

}  // namespace

TEST_CASE("sparse_bilateral of one radius agrees with its oracle") { checkSizes(maker(false)); }

TEST_CASE("sparse_bilateral that follows confidence agrees with its oracle") { checkSizes(maker(true)); }

TEST_CASE("sparse_bilateral leaves out background") {
  checkHoles(maker(false));
  checkHoles(maker(true));
}

TEST_CASE("sparse_bilateral does not depend on the work-group") {
  checkWorkGroups(maker(true), {"sparseOutput"});
}

TEST_CASE("sparse_bilateral turns its taps from frame to frame") {
  CaseOptions options;
  options.size = {131, 40};
  SparseBilateralCase sparse(options);
  std::vector<Planes> results;
  for (std::uint32_t frame = 1; frame <= 3; ++frame) {
    sparse.useFrame(frame);
    sparse.uploadAndRun();
    checkComparison(sparse.compare(), sparse, options);
    for (const Planes& other : results) CHECK(!sameBits(other, sparse.filtered()));
    results.push_back(sparse.filtered());
  }
}

TEST_CASE("sparse_bilateral leaves pixels alone where all history is trusted") {
  for (const CaseOptions& options : bothMappings()) {
    SparseBilateralCase trusted(options, true);
    fill(trusted.inputs.cellConfidence, 1.0f);
    fill(trusted.inputs.windowConfidence, 1.0f);
    fill(trusted.inputs.guides.guides, 1.0f);
    trusted.uploadAndRun();
    CHECK(sameBits(trusted.filtered(), trusted.inputs.irradiance));
  }
}

TEST_CASE("the points of a sunflower are where they are said to be") {
  int i = 0;
  const auto check = [&](int x, int y) {
    const double radius = QUELL_SUNFLOWER_UNIT * std::sqrt((i + 0.5) / QUELL_SUNFLOWER_POINTS);
    const double angle = i * 3.14159265358979323846 * (3.0 - std::sqrt(5.0));
    CHECK(x == Approx(radius * std::cos(angle)).margin(0.5001));
    CHECK(y == Approx(radius * std::sin(angle)).margin(0.5001));
    ++i;
  };
#define POINT(x, y) check(x, y);
  QUELL_SUNFLOWER(POINT)
#undef POINT
  CHECK(i == QUELL_SUNFLOWER_POINTS);
}

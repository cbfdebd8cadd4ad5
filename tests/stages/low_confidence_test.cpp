#include "tests/cases/low_confidence_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

TEST_CASE("low_confidence agrees with its oracle") {
  checkSizes([](const CaseOptions& options) { return std::make_unique<LowConfidenceCase>(options); });
}

TEST_CASE("low_confidence finds a single pixel, and none without a sample") {
  for (const CaseOptions& options : bothMappings({50, 20})) {
    LowConfidenceCase low(options);
    fill(low.confidence, 1.0f);
    fill(low.guides, 1.0f);
    low.confidence.at(0, 31, 15) = 0.25f;
    low.confidence.at(0, 3, 3) = 0.5f;
    low.guides.at(QUELL_GUIDE_WEIGHT, 3, 3) = 0.0f;
    low.uploadAndRun();
    const Planes cells = low.cells();
    forEachPixel(cells.size(),
                 [&](int x, int y) { CHECK(cells.at(0, x, y) == (x == 1 && y == 1 ? 0.25f : 1.0f)); });
  }
}

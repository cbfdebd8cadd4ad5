#include <algorithm>

#include "kernels/accumulate_noisy_params.h"
#include "tests/cases/accumulate_filtered_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

std::unique_ptr<StageCase> make(const CaseOptions& options) {
  return std::make_unique<AccumulateFilteredCase>(options);
}

// No motion, all taps accepted that have a weight, history of this length everywhere.
void standStill(AccumulateFilteredInputs& inputs, float length) {
  forEachPixel(inputs.fitted.size(), [&](int x, int y) {
    inputs.pixelPrev.at(0, x, y) = float(x);
    inputs.pixelPrev.at(1, x, y) = float(y);
    inputs.reprojectionMask.at(0, x, y) = QUELL_PREV_IN_FRAME | QUELL_TAP_ACCEPTED(0);
    inputs.historyLength.at(0, x, y) = length;
  });
}

}  // namespace

TEST_CASE("accumulate_filtered agrees with its oracle") { checkSizes(make); }

TEST_CASE("accumulate_filtered leaves out background") { checkHoles(make); }

TEST_CASE("accumulate_filtered does not depend on the work-group") { checkWorkGroups(make, {"filtered"}); }

TEST_CASE("accumulate_filtered without history is the fitted frame") {
  AccumulateFilteredCase filtered({});
  for (float& mask : filtered.inputs.reprojectionMask.values) mask = QUELL_PREV_IN_FRAME;
  filtered.uploadAndRun();
  CHECK(sameBits(filtered.filtered(), filtered.inputs.fitted));
}

TEST_CASE("accumulate_filtered keeps a constant") {
  for (const CaseOptions& options : bothMappings()) {
    AccumulateFilteredCase filtered(options);
    std::fill(filtered.inputs.fitted.values.begin(), filtered.inputs.fitted.values.end(), 3.25f);
    filtered.inputs.filteredPrev = filtered.inputs.fitted;
    filtered.uploadAndRun();
    for (const float value : filtered.filtered().values)
      CHECK(value == Approx(3.25).epsilon(kAccumulateFilteredTolerance));
  }
}

TEST_CASE("accumulate_filtered averages static frames until the weight hits the floor") {
  CaseOptions options;
  options.size = {17, 3};
  AccumulateFilteredCase filtered(options);
  const int framesToFloor = int(1.0 / filtered.inputs.leastWeight);
  double mean = 0.0, expected = 0.0;
  for (int frame = 1; frame <= framesToFloor + 5; ++frame) {
    standStill(filtered.inputs, float(frame));
    if (frame == 1)
      std::fill(filtered.inputs.reprojectionMask.values.begin(),
                filtered.inputs.reprojectionMask.values.end(), 0.0f);
    const double sample = 1.0 + (frame * 7 % 5);
    std::fill(filtered.inputs.fitted.values.begin(), filtered.inputs.fitted.values.end(), float(sample));
    filtered.uploadAndRun();
    filtered.inputs.filteredPrev = filtered.filtered();
    mean += (sample - mean) / frame;
    expected = frame <= framesToFloor ? mean : expected + filtered.inputs.leastWeight * (sample - expected);
    INFO("frame " << frame);
    CHECK(filtered.inputs.filteredPrev.at(1, 16, 2) == Approx(expected).epsilon(1e-5));
  }
}

// What the stage accumulate_noisy makes of the frames before.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/stages/accumulate_noisy_checks.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

TEST_CASE("accumulate_noisy without history is the plain sample") {
  for (const bool frameBefore : {false, true}) {
    CaseOptions options;
    options.size = {61, 40};
    AccumulateNoisyCase noisy(options, kPlain);
    noisy.useReprojection(makeReprojection({}, {}, options.size, frameBefore));
    forEachPixel(options.size,
                 [&](int x, int y) { noisy.inputs.guidesPrev.at(QUELL_GUIDE_WEIGHT, x, y) = 0.0f; });
    noisy.uploadAndRun();
    const auto outputs = noisy.outputs();
    forEachPixel(options.size, [&](int x, int y) {
      const bool surface = isSurface(outputs.guides, x, y);
      const int mask = int(outputs.reprojectionMask.at(0, x, y)) & ~QUELL_HISTORY_REJECTED;
      CHECK(mask == (frameBefore ? QUELL_PREV_IN_FRAME : 0));
      CHECK(outputs.historyLength.at(0, x, y) == (surface ? 1.0f : 0.0f));
      for (int c = 0; c < 3; ++c) {
        const double expected = surface ? noisy.inputs.material.radiance.at(x, y, c) : 0.0;
        CHECK(outputs.irradiance.at(c, x, y) == Approx(expected).margin(8.0 * kAccumulateNoisyTolerance));
      }
    });
  }
}

TEST_CASE("accumulate_noisy of a still camera lands on pixel centres") {
  for (const CaseOptions& options : bothMappings({480, 270})) {
    AccumulateNoisyCase noisy(options);
    standStill(noisy, 1.0f);
    noisy.uploadAndRun();
    const Planes pixelPrev = noisy.outputs().pixelPrev;
    std::size_t elsewhere = 0;
    forEachPixel(options.size, [&](int x, int y) {
      elsewhere += pixelPrev.at(0, x, y) != float(x) || pixelPrev.at(1, x, y) != float(y);
    });
    CHECK(elsewhere == 0);
  }
}

TEST_CASE("accumulate_noisy averages static frames until the weight hits the floor") {
  CaseOptions options;
  options.size = {33, 31};
  AccumulateNoisyCase noisy(options, kPlainWithMoments);
  const int framesToFloor = int(1.0 / noisy.inputs.leastWeight);
  const int x = 10, y = 25;  // on a surface
  double expected = 0.0, mean = 0.0, first = 0.0, second = 0.0;
  for (int frame = 1; frame <= framesToFloor + 4; ++frame) {
    standStill(noisy, float(frame - 1));
    if (frame == 1) noisy.useReprojection(makeReprojection({}, {}, options.size, false));
    const double sample = 1.0 + (frame * 7 % 5);
    std::fill(noisy.inputs.material.radiance.pixels.begin(), noisy.inputs.material.radiance.pixels.end(),
              float(sample));
    noisy.uploadAndRun();
    const auto outputs = noisy.outputs();
    noisy.inputs.irradiancePrev = outputs.irradiance;
    noisy.inputs.momentsPrev = outputs.moments;
    mean += (sample - mean) / frame;
    const double momentsWeight = std::max(1.0 / frame, noisy.inputs.momentsLeastWeight);
    first += (sample - first) * momentsWeight;
    second += (sample * sample - second) * momentsWeight;
    expected = frame <= framesToFloor ? mean : expected + noisy.inputs.leastWeight * (sample - expected);
    INFO("frame " << frame);
    REQUIRE(isSurface(outputs.guides, x, y));
    CHECK(outputs.historyLength.at(0, x, y) == float(frame));
    CHECK(outputs.irradiance.at(0, x, y) == Approx(expected).epsilon(1e-5));
    CHECK(outputs.moments.at(QUELL_MOMENT_FIRST, x, y) == Approx(first).epsilon(1e-5));
    CHECK(outputs.moments.at(QUELL_MOMENT_SECOND, x, y) == Approx(second).epsilon(1e-5));
  }
}

TEST_CASE("accumulate_noisy keeps a constant") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    AccumulateNoisyCase noisy(options, kPlain);
    std::fill(noisy.inputs.material.radiance.pixels.begin(), noisy.inputs.material.radiance.pixels.end(),
              3.25f);
    fill(noisy.inputs.irradiancePrev, 3.25f);
    noisy.uploadAndRun();
    const auto outputs = noisy.outputs();
    forEachPixel(options.size, [&](int x, int y) {
      const double expected = isSurface(outputs.guides, x, y) ? 3.25 : 0.0;
      CHECK(outputs.irradiance.at(0, x, y) == Approx(expected).epsilon(kAccumulateNoisyTolerance));
    });
  }
}

TEST_CASE("accumulate_noisy rejects history that moved beyond the limits") {
  CaseOptions options;
  options.size = {61, 40};
  const auto acceptedTaps = [&](float shift, bool turnNormals) {
    AccumulateNoisyCase noisy(options, kPlain);
    standStill(noisy, 3.0f);
    forEachPixel(options.size, [&](int x, int y) {
      noisy.inputs.guidesPrev.at(QUELL_GUIDE_POSITION + 2, x, y) += shift;
      if (turnNormals) {
        for (int axis = 0; axis < 3; ++axis)
          noisy.inputs.guidesPrev.at(QUELL_GUIDE_NORMAL + axis, x, y) *= -1.0f;
      }
    });
    noisy.uploadAndRun();
    std::size_t accepted = 0;
    for (const float mask : noisy.outputs().reprojectionMask.values) accepted += (int(mask) & 15) != 0;
    return accepted;
  };
  const ReprojectionParams params = makeReprojection({}, {}, options.size);
  const float fenceLimit = params.positionLimitFootprint * 4.0f;  // the nearest surface, the least limit
  const float wallLimit = params.positionLimitFootprint * 7.0f;   // beyond the farthest
  const std::size_t all = acceptedTaps(0.0f, false);
  CHECK(all > 1000);
  CHECK(acceptedTaps(0.9f * fenceLimit, false) == all);
  CHECK(acceptedTaps(1.1f * wallLimit, false) == 0);
  CHECK(acceptedTaps(0.0f, true) == 0);
}

TEST_CASE("accumulate_noisy keeps the history of a pixel without a sample") {
  CaseOptions options;
  options.size = {61, 40};
  AccumulateNoisyCase noisy(options, kPlain);
  standStill(noisy, 3.0f);
  for (float& value : noisy.inputs.material.radiance.pixels) value = std::numeric_limits<float>::quiet_NaN();
  noisy.uploadAndRun();
  const auto outputs = noisy.outputs();
  forEachPixel(options.size, [&](int x, int y) {
    const bool surface = isSurface(outputs.guides, x, y);
    CHECK(outputs.historyLength.at(0, x, y) == (surface ? 3.0f : 0.0f));
    CHECK(outputs.irradiance.at(2, x, y) == (surface ? noisy.inputs.irradiancePrev.at(2, x, y) : 0.0f));
  });
}

TEST_CASE("accumulate_noisy without a sample has nothing new") {
  CaseOptions options;
  options.size = {61, 40};
  AccumulateNoisyCase noisy(options, kEverything);
  for (io::Image* image : {&noisy.inputs.material.radiance, &noisy.inputs.material.glossyRadiance})
    std::fill(image->pixels.begin(), image->pixels.end(), std::numeric_limits<float>::quiet_NaN());
  noisy.uploadAndRun();
  const auto outputs = noisy.outputs();
  CHECK(sameBits(outputs.newestIrradiance, Planes(options.size, 6, -1.0f)));
  CHECK(sameBits(outputs.innovation, Planes(options.size, 2 * QUELL_INNOVATION_PLANES)));
}

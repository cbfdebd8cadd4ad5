#include "kernels/common/guides.h"
#include "tests/cases/firefly_weights_case.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

constexpr float kLongHistory = 8.0f;

CaseMaker maker(int signals) {
  return [signals](const CaseOptions& options) {
    return std::make_unique<FireflyWeightsCase>(options, signals);
  };
}

// Even light on one wall, seen for long.
void makeEven(FireflyWeightsCase& weights, float light) {
  fill(weights.inputs.irradiance, light);
  fill(weights.inputs.historyLength, kLongHistory);
  fill(weights.inputs.guides, 1.0f);
}

void setLight(FireflyWeightsCase& weights, int x, int y, float light) {
  for (int c = 0; c < 3; ++c) weights.inputs.irradiance.at(c, x, y) = light;
}

Planes run(FireflyWeightsCase& weights) {
  weights.uploadAndRun();
  return weights.weights();
}

}  // namespace

TEST_CASE("firefly_weights agrees with its oracle") { checkSizes(maker(1)); }

TEST_CASE("firefly_weights of two signals agrees with its oracle") { checkLayouts(maker(2), {packed(3)}); }

TEST_CASE("firefly_weights leaves out background") { checkHoles(maker(2)); }

TEST_CASE("firefly_weights does not depend on the work-group nor on the number of lanes") {
  checkWorkGroups(maker(2), {"tapWeights"});
}

TEST_CASE("firefly_weights takes weight from one bright pixel, and from that alone") {
  for (const CaseOptions& options : bothMappings()) {
    for (const float scale : {1e-6f, 1.0f, 1e4f}) {
      FireflyWeightsCase weights(options);
      makeEven(weights, 0.5f * scale);
      setLight(weights, 17, 12, 5.0f * scale);
      const Planes result = run(weights);
      forEachPixel(options.size, [&](int x, int y) {
        const bool firefly = x == 17 && y == 12;
        CHECK(result.at(0, x, y) == (firefly ? Approx(0.01) : Approx(1.0)));
      });
    }
  }
}

TEST_CASE("firefly_weights leaves lamps alone that the ring reaches") {
  CaseOptions options;
  FireflyWeightsCase weights(options);
  makeEven(weights, 0.5f);
  for (int y = 10; y < 18; ++y)
    for (int x = 8; x < 16; ++x) setLight(weights, x, y, 50.0f);
  for (const float weight : run(weights).values) CHECK(weight == 1.0f);
}

TEST_CASE("firefly_weights judges no pixel without long history nor without a ring") {
  CaseOptions options;
  FireflyWeightsCase weights(options);
  makeEven(weights, 0.5f);
  setLight(weights, 17, 12, 500.0f);
  weights.inputs.historyLength.at(0, 17, 12) = 3.0f;
  for (const float weight : run(weights).values) CHECK(weight == 1.0f);

  fill(weights.inputs.historyLength, kLongHistory);
  forEachPixel(options.size, [&](int x, int y) {
    const bool around = std::max(std::abs(x - 17), std::abs(y - 12)) <= 3 && (x != 17 || y != 12);
    if (around) weights.inputs.guides.at(QUELL_GUIDE_WEIGHT, x, y) = 0.0f;
  });
  CHECK(run(weights).at(0, 17, 12) == 1.0f);
}

TEST_CASE("firefly_weights leaves the most extreme fireflies a weight above 0") {
  CaseOptions options;
  FireflyWeightsCase weights(options);
  for (const float light : {0.0f, 1e-45f, 1e-30f}) {
    makeEven(weights, light);
    setLight(weights, 17, 12, 65504.0f);
    CHECK(run(weights).at(0, 17, 12) == Approx(1e-12));
  }
}

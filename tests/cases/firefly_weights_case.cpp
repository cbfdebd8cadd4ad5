#include "tests/cases/firefly_weights_case.hpp"

#include "kernels/common/guides.h"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr double kFireflyShare = 0.02;
constexpr int kLongestHistory = 8;  // frames

StageSetup makeFireflyWeightsSetup(const CaseOptions& options, int signals) {
  StageSetup setup = makeSetup(options);
  if (signals == 2) setup.frame.glossyRadiance = makeView(packed(3), setup.size);
  setup.settings.set("fireflyRatio", 3.0);  // not the default
  return setup;
}

}  // namespace

void addFireflies(Planes& irradiance, unsigned seed) {
  Random random(seed);
  for (int first = 0; first < irradiance.count; first += 3) {
    forEachPixel(irradiance.size(), [&](int x, int y) {
      if (random.uniform() >= kFireflyShare) return;
      for (int c = 0; c < 3; ++c) irradiance.at(first + c, x, y) *= float(random.uniform(20.0, 1000.0));
    });
  }
}

void compareTapWeights(Comparison& comparison, const Planes& device, const ExactPlanes& exact) {
  for (int signal = 0; signal < device.count; ++signal) {
    forEachPixel(device.size(), [&](int x, int y) {
      const double weight = exact.at(signal, x, y);
      comparison.include("tap weight", signal, x, y, device.at(signal, x, y), weight,
                         weight > 0.0 ? weight : 1.0);
    });
  }
}

FireflyWeightsCase::FireflyWeightsCase(const CaseOptions& options, int signals)
    : StageCase("firefly_weights", makeFireflyWeightsSetup(options, signals)) {
  inputs.guides = randomGuides({signals, false}, options).guides;
  inputs.irradiance = randomPlanes(options.size, 3 * signals, options.seed + 10, 0.0, 8.0);
  addFireflies(inputs.irradiance, options.seed + 11);
  inputs.historyLength = Planes(options.size, signals);
  Random random(options.seed + 12);
  for (float& length : inputs.historyLength.values) length = float(random.integer(0, kLongestHistory));
  inputs.ratio = m_harness.configuration().settings.get("fireflyRatio");
}

void FireflyWeightsCase::upload() {
  m_harness.upload("irradiance", inputs.irradiance);
  m_harness.upload("guides", inputs.guides);
  m_harness.upload("historyLength", inputs.historyLength);
}

Comparison FireflyWeightsCase::compare() {
  Comparison comparison(leftOut());
  compareTapWeights(comparison, weights(), fireflyWeightsOracle(inputs));
  return comparison;
}

}  // namespace quell::tests

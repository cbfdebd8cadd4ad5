#include "tests/cases/light_sums_case.hpp"

#include "tests/cases/filter_inputs.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

StageSetup makeLightSumsSetup(const CaseOptions& options, int signals) {
  StageSetup setup = makeSetup(options);
  setFilterMethod(setup, "quell", {signals, false});
  return setup;
}

}  // namespace

LightSumsCase::LightSumsCase(const CaseOptions& options, int signals)
    : StageCase("light_sums", makeLightSumsSetup(options, signals)) {
  inputs.stopLuminance = randomPlanes(options.size, signals, options.seed + 10, 0.0, 8.0);
  inputs.filtered = randomPlanes(options.size, 3 * signals, options.seed + 20, 0.0, 8.0);
  inputs.guides = randomGuides({signals, false}, options).guides;
}

void LightSumsCase::upload() {
  m_harness.upload("stopLuminance", inputs.stopLuminance);
  m_harness.upload("filtered", inputs.filtered);
  m_harness.upload("guides", inputs.guides);
}

Planes LightSumsCase::sums() const {
  Planes sums = m_harness.download("lightSums");
  sums.width = TileGrid(size()).count() * inputs.signals() * QUELL_LIGHT_RECORD;
  sums.values.resize(std::size_t(sums.width));
  return sums;
}

Comparison LightSumsCase::compare() {
  Comparison comparison;
  const Planes device = sums();
  const LightSumsExact exact = lightSumsOracle(inputs);
  for (int i = 0; i < exact.sums.width; ++i) {
    const double magnitude = exact.magnitudes.at(0, i, 0);
    // What nothing was added to must be 0.
    comparison.include("sum", 0, i, 0, device.at(0, i, 0), exact.sums.at(0, i, 0),
                       magnitude > 0.0 ? magnitude : 1.0);
  }
  return comparison;
}

}  // namespace quell::tests

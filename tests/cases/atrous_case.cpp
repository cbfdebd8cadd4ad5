#include "tests/cases/atrous_case.hpp"

#include <algorithm>

#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr int kIterations = 5;

StageSetup makeAtrousSetup(const CaseOptions& options, const AtrousVariant& variant) {
  StageSetup setup = makeSetup(options);
  setFilterMethod(setup, variant.ofQuell() ? "quell" : variant.variance ? "svgf" : "atrous", variant.images);
  if (variant.ofQuell()) setup.settings.set("sharpRoughness", variant.sharpRoughness);
  if (variant.ofQuell()) setup.settings.set("prefilteredIterations", kPrefilteredIterations);
  setup.settings.set("iterations", kIterations);
  setup.occurrence = variant.iteration - 1;
  return setup;
}

}  // namespace

AtrousCase::AtrousCase(const CaseOptions& options, const AtrousVariant& variant)
    : StageCase("atrous", makeAtrousSetup(options, variant)) {
  const Settings& settings = m_harness.configuration().settings;
  const int signals = variant.images.signals;
  inputs.guides = randomGuides(variant.images, options);
  inputs.irradiance = randomPlanes(options.size, 3 * signals, options.seed + 10, 0.0, 8.0);
  if (variant.prefiltered())
    inputs.stopLuminance = randomPlanes(options.size, signals, options.seed + 12, 0.0, 8.0);
  if (variant.variance) inputs.variance = randomPlanes(options.size, signals, options.seed + 11, 0.0, 4.0);
  m_holes.clear(inputs.variance);
  m_holes.zeroesVariance = variant.iteration <= 2;
  inputs.stops = edgeStopsOf(settings);
  inputs.radius = variant.ofQuell() && variant.iteration > 1 ? 1 : 2;
  inputs.corners = !variant.ofQuell() || variant.iteration == 2 || variant.iteration == 3;
  inputs.sharpRoughness = std::max(variant.sharpRoughness, 0.0);
  inputs.step = 1 << (variant.iteration - 1);
  // Without variance the tolerated difference shrinks with the noise that is left.
  inputs.luminanceSigma = variant.prefiltered()
                              ? settings.get("prefilteredSigma")
                              : settings.get("luminanceSigma") / (variant.variance ? 1 : inputs.step);
}

bool AtrousCase::filtersVariance() const {
  const std::vector<Port>& ports = m_harness.ports();
  return std::any_of(ports.begin(), ports.end(), [](const Port& port) {
    return port.exists && port.name == std::string("filteredVariance") && port.touched > 0.0;
  });
}

void AtrousCase::upload() {
  uploadGuides(m_harness, inputs.guides);
  uploadTapWeights(m_harness, inputs.guides.guides);
  m_harness.upload("irradiance", inputs.irradiance);
  if (inputs.variance.count > 0) m_harness.upload("variance", inputs.variance);
  if (inputs.stopLuminance.count > 0) m_harness.upload("stopLuminance", inputs.stopLuminance);
}

Comparison AtrousCase::compare() {
  Comparison comparison(leftOut());
  const AtrousExact exact = atrousOracle(inputs);
  comparison.exclude(exact.undecided);
  comparePixels(comparison, "irradiance", irradiance(), exact.irradiance, &exact.undecided, nullptr,
                lightUnit());
  if (filtersVariance())
    comparePixels(comparison, "variance", variance(), exact.variance, &exact.undecided, nullptr,
                  lightUnit() * lightUnit());
  return comparison;
}

}  // namespace quell::tests

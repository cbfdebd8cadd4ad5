#include "tests/cases/separable_bilateral_case.hpp"

#include <algorithm>

#include "kernels/common/guides.h"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

StageSetup makeSeparableBilateralSetup(const CaseOptions& options, bool alongRows, bool roughness) {
  StageSetup setup = makeEdagiSetup(options, {2, roughness, false});
  setup.settings.set("roughnessSigma", 0.5);
  setup.occurrence = alongRows ? 1 : 0;
  return setup;
}

}  // namespace

SeparableBilateralCase::SeparableBilateralCase(const CaseOptions& options, bool alongRows, bool roughness)
    : StageCase("separable_bilateral", makeSeparableBilateralSetup(options, alongRows, roughness)) {
  const Settings& settings = m_harness.configuration().settings;
  inputs.guides = randomGuides({2, roughness}, options);
  inputs.weights = planesOf(inputs.guides.guides, QUELL_GUIDE_WEIGHT + 1, 1);
  inputs.irradiance = randomPlanes(options.size, 3, options.seed + 10, 0.0, 8.0);
  inputs.stops = edgeStopsOf(settings);
  inputs.sigma = settings.get("glossySigma");
  inputs.alongRows = alongRows;
}

void SeparableBilateralCase::upload() {
  uploadGuides(m_harness, inputs.guides);
  Planes both(size(), 6, 33.0f);
  std::copy(inputs.irradiance.values.begin(), inputs.irradiance.values.end(),
            both.values.begin() + std::ptrdiff_t(inputs.irradiance.values.size()));
  m_harness.upload("separableInput", both);
}

Comparison SeparableBilateralCase::compare() {
  Comparison comparison(leftOut());
  const SeparableBilateralExact exact = separableBilateralOracle(inputs);
  comparison.exclude(exact.undecided);
  comparePixels(comparison, "irradiance", filtered(), exact.irradiance, &exact.undecided, nullptr,
                lightUnit());
  return comparison;
}

}  // namespace quell::tests

#include "tests/cases/demodulate_case.hpp"

#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

StageSetup makeDemodulateSetup(const CaseOptions& options, const FrameVariant& variant) {
  StageSetup setup = makeSetup(options);
  setup.settings = Settings("atrous");
  setFrameViews(setup, variant, options.layout);
  return setup;
}

}  // namespace

DemodulateCase::DemodulateCase(const CaseOptions& options, const FrameVariant& variant)
    : StageCase("demodulate", makeDemodulateSetup(options, variant)),
      inputs(randomFrame(variant, options.size, options.seed)) {
  inputs.reprojection = makeReprojection({}, {}, options.size);
  m_reprojection = inputs.reprojection;
}

void DemodulateCase::upload() { uploadFrame(m_harness, inputs); }

Comparison DemodulateCase::compare() {
  Comparison comparison;
  const DemodulateExact exact = demodulateOracle(inputs);
  for (const char undecided : exact.undecided.values)
    if (undecided) comparison.exclude();
  comparePixels(comparison, "irradiance", irradiance(), exact.irradiance, &exact.undecided);
  comparePixels(comparison, "guides", guides(), exact.guides, &exact.undecided);
  comparePixels(comparison, "viewDepth", m_harness.download("viewDepth"), exact.viewDepth, &exact.undecided);
  if (!inputs.roughness.empty())
    comparePixels(comparison, "roughness", m_harness.download("roughness"), exact.roughness,
                  &exact.undecided);
  return comparison;
}

}  // namespace quell::tests

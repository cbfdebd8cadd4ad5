#include "tests/cases/remodulate_case.hpp"

#include "tests/oracle/display_encoding_oracle.hpp"
#include "tests/oracle/tiles_oracle.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

StageSetup makeRemodulateSetup(const CaseOptions& options, const MaterialVariant& variant, RemodulateTo to,
                               LightLoss loss, const DisplayTransform& transform) {
  StageSetup setup = makeSetup(options);
  if (loss == LightLoss::GivenBack) setup.settings = Settings("quell");
  setMaterialViews(setup, variant, options.layout);
  setup.output.linear = makeView(options.layout, options.size);
  setup.output.display = makeView(options.layout, options.size);
  setup.settings.set("toneMap", double(transform.toneMap));
  setup.settings.set("displayEncoding", double(transform.encoding));
  setup.settings.set("exposure", transform.exposure);
  setup.settings.set("taa", to == RemodulateTo::Outputs ? "off" : "on");
  setup.settings.set("jitteredRays", to == RemodulateTo::AntialiasingOnly ? "on" : "off");
  return setup;
}

}  // namespace

RemodulateCase::RemodulateCase(const CaseOptions& options, const MaterialVariant& variant, RemodulateTo to,
                               LightLoss loss, const DisplayTransform& transform)
    : StageCase("remodulate", makeRemodulateSetup(options, variant, to, loss, transform)),
      m_to(to),
      m_layout(options.layout) {
  inputs.material = randomMaterial(variant, options.size, options.seed);
  const int signals = inputs.material.signals();
  inputs.filtered = randomPlanes(options.size, 3 * signals, options.seed + 10, 0.0, 8.0);
  inputs.guides = renderScene({}, options.size, signals, options.holes()).guides;
  // Up to ratios beyond what they are limited to.
  if (loss == LightLoss::GivenBack)
    inputs.lightGain =
        randomPlanes({TileGrid(options.size).count() * signals, 1}, 1, options.seed + 20, -0.3, 0.3);
}

void RemodulateCase::upload() {
  uploadMaterial(m_harness, inputs.material);
  m_harness.upload("filtered", inputs.filtered);
  m_harness.upload("guides", inputs.guides);
  if (inputs.lightGain.count > 0) m_harness.upload("lightGain", inputs.lightGain);
}

Comparison RemodulateCase::compare() {
  Comparison comparison(leftOut());
  const RemodulateExact exact = remodulateOracle(inputs);
  comparison.exclude(exact.undecided);
  if (m_to != RemodulateTo::AntialiasingOnly)
    compareOutput(comparison, m_harness, &Output::linear, exact.linear, &exact.undecided, &exact.magnitude,
                  lightUnit());
  if (m_to == RemodulateTo::Outputs) {
    compareOutput(comparison, m_harness, &Output::display, exact.encoded, &exact.undecided, nullptr,
                  displayUnit(kRemodulateTolerance));
  } else {
    comparePixels(comparison, "beforeAntialiasing", m_harness.download("beforeAntialiasing"), exact.linear,
                  &exact.undecided, &exact.magnitude, lightUnit());
  }
  return comparison;
}

}  // namespace quell::tests

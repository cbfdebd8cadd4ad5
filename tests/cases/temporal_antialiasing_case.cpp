#include "tests/cases/temporal_antialiasing_case.hpp"

#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

StageSetup makeTemporalAntialiasingSetup(const CaseOptions& options) {
  StageSetup setup = makeSetup(options);
  if (options.holes()) setup.settings = Settings("quell");  // the others leave nothing out here
  setup.output.display = makeView(options.layout, options.size);
  return setup;
}

}  // namespace

TemporalAntialiasingCase::TemporalAntialiasingCase(const CaseOptions& options)
    : StageCase("temporal_antialiasing", makeTemporalAntialiasingSetup(options)), m_layout(options.layout) {
  const RandomMotion motion = randomMotion(options.size, options.seed);
  inputs.encoded = randomPlanes(options.size, 3, options.seed + 1);
  inputs.antialiasedPrev = randomPlanes(options.size, 3, options.seed + 2);
  inputs.pixelPrev = motion.pixelPrev;
  inputs.reprojectionMask = motion.reprojectionMask;
  inputs.newestWeight = float(m_harness.configuration().settings.get("taaNewestWeight"));
}

void TemporalAntialiasingCase::upload() {
  m_harness.upload("encoded", inputs.encoded);
  m_harness.upload("antialiasedPrev", inputs.antialiasedPrev);
  m_harness.upload("pixelPrev", inputs.pixelPrev);
  m_harness.upload("reprojectionMask", inputs.reprojectionMask);
}

Comparison TemporalAntialiasingCase::compare() {
  Comparison comparison(leftOut());
  const ExactPlanes exact = temporalAntialiasingOracle(inputs);
  comparePixels(comparison, "antialiased", antialiased(), exact);
  compareOutput(comparison, m_harness, &Output::display, exact);
  return comparison;
}

}  // namespace quell::tests

#include "tests/cases/temporal_antialiasing_case.hpp"

#include "tests/oracle/display_encoding_oracle.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

StageSetup makeTemporalAntialiasingSetup(const CaseOptions& options, bool jitteredRays) {
  StageSetup setup = makeSetup(options);
  if (options.holes()) setup.settings = Settings("quell");  // the others leave nothing out here
  setup.output.linear = makeView(options.layout, options.size);
  setup.output.display = makeView(options.layout, options.size);
  setup.settings.set("jitteredRays", jitteredRays ? "on" : "off");
  return setup;
}

// Surfaces at several depths, sloped a little, and background.
Planes randomDepths(Size size, unsigned seed) {
  constexpr double kDepths[] = {0.0, 2.0, 3.0, 8.0};
  Random random(seed);
  Planes depths(size, 1);
  for (float& depth : depths.values) {
    const bool other = random.uniform() < 0.1;
    depth = float(kDepths[other ? random.integer(0, 3) : 2] * random.uniform(0.99, 1.01));
  }
  return depths;
}

}  // namespace

TemporalAntialiasingCase::TemporalAntialiasingCase(const CaseOptions& options, bool jitteredRays)
    : StageCase("temporal_antialiasing", makeTemporalAntialiasingSetup(options, jitteredRays)),
      m_layout(options.layout),
      m_jitteredRays(jitteredRays) {
  const RandomMotion motion = randomMotion(options.size, options.seed);
  inputs.denoised = randomPlanes(options.size, 3, options.seed + 1);
  inputs.antialiasedPrev = randomPlanes(options.size, 3, options.seed + 2);
  inputs.pixelPrev = motion.pixelPrev;
  inputs.reprojectionMask = motion.reprojectionMask;
  inputs.viewDepth = randomDepths(options.size, options.seed + 3);
  m_holes.clear(inputs.viewDepth);
  inputs.antialiasBackground = options.skip != Skip::On;
  const Settings& settings = m_harness.configuration().settings;
  inputs.newestWeight = float(settings.get(jitteredRays ? "taaJitteredWeight" : "taaNewestWeight"));
  inputs.silhouetteWeight = float(settings.get("taaSilhouetteWeight"));
}

void TemporalAntialiasingCase::upload() {
  m_harness.upload("beforeAntialiasing", inputs.denoised);
  m_harness.upload("antialiasedPrev", inputs.antialiasedPrev);
  m_harness.upload("pixelPrev", inputs.pixelPrev);
  m_harness.upload("reprojectionMask", inputs.reprojectionMask);
  m_harness.upload("viewDepth", inputs.viewDepth);
}

Comparison TemporalAntialiasingCase::compare() {
  Comparison comparison(leftOut());
  const ExactPlanes exact = temporalAntialiasingOracle(inputs);
  ExactPlanes encoded = exact;
  for (double& value : encoded.values) value = encodeDisplayExact(value);
  comparePixels(comparison, "antialiased", antialiased(), exact, nullptr, nullptr, lightUnit());
  compareOutput(comparison, m_harness, &Output::display, encoded, nullptr, nullptr,
                displayUnit(kTemporalAntialiasingTolerance));
  if (m_jitteredRays)
    compareOutput(comparison, m_harness, &Output::linear, exact, nullptr, nullptr, lightUnit());
  return comparison;
}

}  // namespace quell::tests

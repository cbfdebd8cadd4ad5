#include "tests/cases/background_case.hpp"

#include "tests/cases/material_inputs.hpp"
#include "tests/cases/surface_items.hpp"
#include "tests/oracle/display_encoding_oracle.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr double kShareOfSurfaces = 0.3;

StageSetup makeBackgroundSetup(const CaseOptions& options) {
  StageSetup setup = makeSetup(options);
  setup.settings = Settings("quell");
  setup.skip = true;
  setMaterialViews(setup, {true, false, false, false}, options.layout);
  setup.output.linear = makeView(options.layout, options.size);
  setup.output.display = makeView(options.layout, options.size);
  return setup;
}

// Radiance of which emission is a part, as a renderer gives it.
BackgroundInputs randomInputs(Size size, unsigned seed) {
  const MaterialImages material = randomMaterial({true, false, false, false}, size, seed);
  return {material.radiance, material.emission};
}

}  // namespace

BackgroundCase::BackgroundCase(const CaseOptions& options)
    : StageCase("background", makeBackgroundSetup(options)),
      inputs(randomInputs(options.size, options.seed)),
      m_layout(options.layout),
      m_lanes(m_harness.configuration().device.lanes) {
  surfaces = Planes({(options.size.width + m_lanes - 1) / m_lanes, options.size.height}, 1);
  Random random(options.seed + 1);
  for (float& surface : surfaces.values) surface = random.uniform() < kShareOfSurfaces ? 1.0f : 0.0f;
  surfaces.values.front() = 0.0f;  // an image of one pixel has something to show
}

bool BackgroundCase::isBackground(int x, int y) const { return !hasSurface(surfaces, x / m_lanes, y); }

void BackgroundCase::upload() {
  uploadImage(m_harness, &Frame::radiance, inputs.radiance);
  uploadImage(m_harness, &Frame::emission, inputs.emission);
  m_harness.upload("surfaces", surfaces);
  const Planes untouched(size(), 3, -1.0f);
  m_harness.upload("beforeAntialiasing", untouched);
  m_harness.upload("antialiased", untouched);
  m_harness.clearOutput(&Output::linear);
  m_harness.clearOutput(&Output::display);
}

Comparison BackgroundCase::compare() {
  Comparison comparison;
  const BackgroundExact exact = backgroundOracle(inputs);
  BasicPlanes<char> surface(size(), 1);
  forEachPixel(size(), [&](int x, int y) { surface.at(0, x, y) = char(!isBackground(x, y)); });
  comparePixels(comparison, "linear", outputPlanes(m_harness, &Output::linear), exact.linear, &surface,
                nullptr, lightUnit());
  comparePixels(comparison, "display", outputPlanes(m_harness, &Output::display), exact.encoded, &surface,
                nullptr, displayUnit(kBackgroundTolerance));
  comparePixels(comparison, "antialiased", antialiased(), exact.linear, &surface, nullptr, lightUnit());
  forEachPixel(size(), [&](int x, int y) {
    surface.at(0, x, y) = char(!isBackground(x, y) || !isSeenByAntialiasing(surfaces, m_lanes, x, y));
  });
  comparePixels(comparison, "beforeAntialiasing", denoised(), exact.linear, &surface, nullptr, lightUnit());
  return comparison;
}

}  // namespace quell::tests

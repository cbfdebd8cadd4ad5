#include "tests/cases/gram_sums_case.hpp"

#include <cmath>
#include <limits>

#include "kernels/accumulate_noisy_params.h"
#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

constexpr double kLessWeightShare = 0.1;  // of the pixels

void compareSums(Comparison& comparison, const std::string& tile, const GramMatrix& device,
                 const GramMatrix& exact) {
  for (int a = 0; a < QUELL_FIT_COLUMNS; ++a) {
    for (int b = a; b < QUELL_FIT_COLUMNS; ++b) {
      const double scale = std::sqrt(exact(a, a) * exact(b, b));
      // Without any product the sum must be 0.
      comparison.include("sum of " + tile, 0, a, b, device(a, b), exact(a, b), scale > 0.0 ? scale : 1.0);
    }
  }
}

void compareRanges(Comparison& comparison, const std::string& tile, const PositionRange& device,
                   const PositionRange& exact) {
  if (device.empty() && exact.empty()) return comparison.include("no range", 0, 0, 0, 0.0, 0.0);
  if (device.low == exact.low && device.high == exact.high) return;
  comparison.include("range of " + tile, 0, 0, 0, std::numeric_limits<double>::infinity(), 0.0);
}

}  // namespace

StageSetup makeGramSetup(const CaseOptions& options, const GramWindows& windows, double noiseAmplitude) {
  StageSetup setup = makeSetup(options);
  setup.settings.set("solver", "gram");
  setup.settings.set("noiseAmplitude", noiseAmplitude);
  if (windows.overlap) {
    setup.settings.set("windows", "overlap");
    setup.settings.set("tileSize", std::to_string(windows.tileEdge));
  }
  return setup;
}

GramInputs makeGramInputs(const CaseOptions& options, const GramWindows& windows) {
  GramInputs inputs;
  inputs.irradiance = randomPlanes(options.size, 3, options.seed, 0.0, 8.0);
  inputs.guides = renderScene({}, options.size).guides;
  Random random(options.seed + 1);
  forEachPixel(options.size, [&](int x, int y) {
    if (random.uniform() < kLessWeightShare)
      inputs.guides.at(QUELL_GUIDE_WEIGHT, x, y) *= float(random.uniform());
  });
  inputs.tileEdge = windows.tileEdge;
  inputs.overlap = windows.overlap;
  return inputs;
}

void useRandomFeatures(Planes& guides, unsigned seed) {
  guides = randomPlanes(guides.size(), QUELL_GUIDE_PLANES, seed, -1.0, 1.0);
  forEachPixel(guides.size(), [&](int x, int y) { guides.at(QUELL_GUIDE_WEIGHT, x, y) = 1.0f; });
}

GramSumsCase::GramSumsCase(const CaseOptions& options, GramWindows windows)
    : StageCase("gram_sums", makeGramSetup(options, windows, 0.0)),
      inputs(makeGramInputs(options, windows)),
      m_windows(windows) {
  useFrame(1);
}

void GramSumsCase::useFrame(std::uint32_t frameIndex) {
  m_frameIndex = frameIndex;
  inputs.params = makeGramParams(m_windows, size(), frameIndex, 0.0);
}

void GramSumsCase::upload() {
  m_harness.upload("irradiance", inputs.irradiance);
  m_harness.upload("guides", inputs.guides);
}

Comparison GramSumsCase::compare() {
  Comparison comparison;
  const std::vector<GramTile> exact = gramSumsOracle(inputs);
  const Planes device = tiles();
  for (int tile = 0; tile < gramTileCount(inputs.params); ++tile) {
    const GramTile unpacked = unpackTile(device, inputs.params, tile);
    const std::string name = "tile " + std::to_string(tile);
    compareSums(comparison, name, unpacked.sums, exact[std::size_t(tile)].sums);
    compareRanges(comparison, name, unpacked.range, exact[std::size_t(tile)].range);
  }
  return comparison;
}

}  // namespace quell::tests

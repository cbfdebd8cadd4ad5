#include "tests/cases/gram_sums_case.hpp"

#include <cmath>
#include <limits>

#include "kernels/accumulate_noisy_params.h"
#include "tests/cases/feature_inputs.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

constexpr double kLessWeightShare = 0.1;  // of the pixels
constexpr double kLeastSize = 10.0;       // scene units, of positions that a variable is made of

void compareSums(Comparison& comparison, const std::string& tile, const GramMatrix& device,
                 const GramMatrix& exact) {
  for (int a = 0; a < int(exact.cols()); ++a) {
    for (int b = a; b < int(exact.cols()); ++b) {
      const double scale = std::sqrt(exact(a, a) * exact(b, b));
      // Without any product the sum must be 0.
      comparison.include("sum of " + tile, 0, a, b, device(a, b), exact(a, b), scale > 0.0 ? scale : 1.0);
    }
  }
}

// Those of variables that are stored must agree exactly.
void compareRanges(Comparison& comparison, const std::string& tile, const VariableRange& device,
                   const VariableRange& exact) {
  if (device.empty() && exact.empty()) return comparison.include("no range", 0, 0, 0, 0.0, 0.0);
  for (int i = 0; i < int(exact.low.size()); ++i) {
    const std::size_t k = std::size_t(i);
    const bool stored = exact.list.scaled[k].size() == 2;
    const double scale = stored ? 0.0 : std::abs(exact.low[k]) + std::abs(exact.high[k]) + kLeastSize;
    for (const auto& [got, wanted] :
         {std::pair(device.low[k], exact.low[k]), std::pair(device.high[k], exact.high[k])}) {
      if (got == wanted) continue;
      comparison.include("range of " + tile, 0, i, 0, stored ? std::numeric_limits<double>::infinity() : got,
                         wanted, scale);
    }
  }
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
  inputs.guides = withMaterials(renderScene({}, options.size, 1, options.holes()).guides, options.seed + 2);
  inputs.list = gramNamesOf(FitFeatures(options.features), windows.overlap);
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
  guides = randomPlanes(guides.size(), kGuideAndMaterialPlanes, seed, -1.0, 1.0);
  forEachPixel(guides.size(), [&](int x, int y) { guides.at(QUELL_GUIDE_WEIGHT, x, y) = 1.0f; });
}

GramSumsCase::GramSumsCase(const CaseOptions& options, GramWindows windows)
    : StageCase("gram_sums", makeGramSetup(options, windows, 0.0)),
      inputs(makeGramInputs(options, windows)),
      m_windows(windows),
      m_features(options.features) {
  m_reprojection.viewDepth = viewAxisOf(inputs.list);
  useFrame(1);
}

void GramSumsCase::useFrame(std::uint32_t frameIndex) {
  m_frameIndex = frameIndex;
  inputs.params = makeGramParams(m_windows, size(), frameIndex, 0.0);
}

void GramSumsCase::upload() {
  m_harness.upload("irradiance", inputs.irradiance);
  m_harness.upload("guides", inputs.guides);
  uploadTapWeights(m_harness, inputs.guides);
  if (m_features.needMaterial()) m_harness.upload("materials", materialsOf(inputs.guides));
}

Comparison GramSumsCase::compare() {
  Comparison comparison;
  const std::vector<GramTile> exact = gramSumsOracle(inputs);
  const Planes device = tiles();
  for (int tile = 0; tile < gramTileCount(inputs.params); ++tile) {
    const GramTile unpacked = unpackTile(device, inputs.params, tile, inputs.list);
    const std::string name = "tile " + std::to_string(tile);
    compareSums(comparison, name, unpacked.sums, exact[std::size_t(tile)].sums);
    compareRanges(comparison, name, unpacked.range, exact[std::size_t(tile)].range);
  }
  return comparison;
}

}  // namespace quell::tests

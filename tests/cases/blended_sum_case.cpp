#include "tests/cases/blended_sum_case.hpp"

#include <algorithm>

#include "tests/cases/feature_inputs.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
BlendedSumCase::BlendedSumCase(const CaseOptions& options, GramWindows windows)
    : StageCase("blended_sum", makeGramSetup(options, windows, 0.0)),
      m_windows(windows),
      m_features(options.features) {
  inputs.guides = withMaterials(renderScene({}, options.size, 1, options.holes()).guides, options.seed + 2);
  inputs.list = namesOf(m_features);
  m_reprojection.viewDepth = viewAxisOf(inputs.list);
  inputs.tileEdge = windows.tileEdge;
  useFrame(1);
  inputs.records = randomRecords(inputs.list, inputs.params.tilesX * inputs.params.tilesY, options.seed);
}

void BlendedSumCase::useFrame(std::uint32_t frameIndex) {
  m_frameIndex = frameIndex;
  inputs.params = makeGramParams(m_windows, size(), frameIndex, 0.0);
}

void BlendedSumCase::upload() {
  m_harness.upload("fitRecords", inputs.records);
  m_harness.upload("guides", inputs.guides);
  if (m_features.needMaterial()) m_harness.upload("materials", materialsOf(inputs.guides));
}

Comparison BlendedSumCase::compare() {
  Comparison comparison(leftOut());
  const BlendedSumExact exact = blendedSumOracle(inputs);
  const Planes device = fitted();
  forEachPixel(size(), [&](int x, int y) {
    for (int c = 0; c < 3; ++c)
      comparison.include("fitted", c, x, y, device.at(c, x, y), exact.fitted.at(c, x, y),
                         std::max(1.0, exact.magnitude.at(c, x, y)));
  });
  return comparison;
}

}  // namespace quell::tests

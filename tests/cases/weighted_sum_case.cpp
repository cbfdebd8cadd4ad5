#include "tests/cases/weighted_sum_case.hpp"

#include <algorithm>

#include "host/stages/fit.hpp"
#include "tests/cases/feature_inputs.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
WeightedSumCase::WeightedSumCase(const CaseOptions& options)
    : StageCase("weighted_sum", makeSetup(options)), m_features(options.features) {
  inputs.guides = withMaterials(renderScene({}, options.size, 1, options.holes()).guides, options.seed + 2);
  inputs.list = namesOf(m_features);
  m_reprojection.viewDepth = viewAxisOf(inputs.list);
  inputs.records = randomRecords(inputs.list, blockCount(options.size), options.seed);
  useFrame(1);
}

void WeightedSumCase::useFrame(std::uint32_t frameIndex) {
  m_frameIndex = frameIndex;
  inputs.params = makeFitParams(size(), frameIndex, 0.0);
}

void WeightedSumCase::upload() {
  m_harness.upload("fitRecords", inputs.records);
  m_harness.upload("guides", inputs.guides);
  if (m_features.needMaterial()) m_harness.upload("materials", materialsOf(inputs.guides));
}

Comparison WeightedSumCase::compare() {
  Comparison comparison(leftOut());
  const WeightedSumExact exact = weightedSumOracle(inputs);
  const Planes device = fitted();
  forEachPixel(size(), [&](int x, int y) {
    for (int c = 0; c < 3; ++c)
      comparison.include("fitted", c, x, y, device.at(c, x, y), exact.fitted.at(c, x, y),
                         std::max(1.0, exact.magnitude.at(c, x, y)));
  });
  return comparison;
}

}  // namespace quell::tests

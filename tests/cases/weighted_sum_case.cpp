#include "tests/cases/weighted_sum_case.hpp"

#include <algorithm>

#include "host/stages/fit.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

Planes randomRecords(Size size, unsigned seed) {
  Random random(seed);
  std::vector<FitRecord> records(std::size_t(blockCount(size)));
  for (FitRecord& record : records) {
    record.coefficients = record.coefficients.unaryExpr([&](double) { return random.uniform(-1.0, 2.0); });
    for (double& anchor : record.anchor) anchor = random.uniform(-8.0, 2.0);
    for (double& scale : record.scale) scale = random.uniform(0.1, 2.0);
  }
  return packRecords(records);
}

}  // namespace

WeightedSumCase::WeightedSumCase(const CaseOptions& options) : StageCase("weighted_sum", makeSetup(options)) {
  inputs.records = randomRecords(options.size, options.seed);
  inputs.guides = renderScene({}, options.size).guides;
  useFrame(1);
}

void WeightedSumCase::useFrame(std::uint32_t frameIndex) {
  m_frameIndex = frameIndex;
  inputs.params = makeFitParams(size(), frameIndex, 0.0);
}

void WeightedSumCase::upload() {
  m_harness.upload("fitRecords", inputs.records);
  m_harness.upload("guides", inputs.guides);
}

Comparison WeightedSumCase::compare() {
  Comparison comparison;
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

#include "tests/cases/blended_sum_case.hpp"

#include <algorithm>

#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

Planes randomRecords(int count, unsigned seed) {
  Random random(seed);
  std::vector<FitRecord> records(static_cast<std::size_t>(count));
  for (FitRecord& record : records) {
    record.coefficients = record.coefficients.unaryExpr([&](double) { return random.uniform(-1.0, 2.0); });
    for (double& anchor : record.anchor) anchor = random.uniform(-8.0, 2.0);
    for (double& scale : record.scale) scale = random.uniform(0.1, 2.0);
  }
  return packRecords(records);
}

}  // namespace

BlendedSumCase::BlendedSumCase(const CaseOptions& options, GramWindows windows)
    : StageCase("blended_sum", makeGramSetup(options, windows, 0.0)), m_windows(windows) {
  inputs.guides = renderScene({}, options.size).guides;
  inputs.tileEdge = windows.tileEdge;
  useFrame(1);
  inputs.records = randomRecords(inputs.params.tilesX * inputs.params.tilesY, options.seed);
}

void BlendedSumCase::useFrame(std::uint32_t frameIndex) {
  m_frameIndex = frameIndex;
  inputs.params = makeGramParams(m_windows, size(), frameIndex, 0.0);
}

void BlendedSumCase::upload() {
  m_harness.upload("fitRecords", inputs.records);
  m_harness.upload("guides", inputs.guides);
}

Comparison BlendedSumCase::compare() {
  Comparison comparison;
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

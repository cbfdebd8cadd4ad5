#include "tests/cases/accumulate_filtered_case.hpp"

#include <cmath>

#include "tests/support/random_images.hpp"

namespace quell::tests {

AccumulateFilteredCase::AccumulateFilteredCase(const CaseOptions& options)
    : StageCase("accumulate_filtered", makeSetup(options)) {
  const RandomMotion motion = randomMotion(options.size, options.seed);
  inputs.fitted = randomPlanes(options.size, 3, options.seed + 1, 0.0, 8.0);
  inputs.filteredPrev = randomPlanes(options.size, 3, options.seed + 2, 0.0, 8.0);
  inputs.pixelPrev = motion.pixelPrev;
  inputs.reprojectionMask = motion.reprojectionMask;
  inputs.historyLength = randomPlanes(options.size, 1, options.seed + 3, 0.0, 20.0);
  for (float& length : inputs.historyLength.values) length = std::floor(length);
  inputs.leastWeight = float(m_harness.configuration().settings.get("filteredLeastWeight"));
}

void AccumulateFilteredCase::upload() {
  m_harness.upload("fitted", inputs.fitted);
  m_harness.upload("filteredPrev", inputs.filteredPrev);
  m_harness.upload("pixelPrev", inputs.pixelPrev);
  m_harness.upload("reprojectionMask", inputs.reprojectionMask);
  m_harness.upload("historyLength", inputs.historyLength);
}

Comparison AccumulateFilteredCase::compare() {
  Comparison comparison(leftOut());
  comparePixels(comparison, "filtered", filtered(), accumulateFilteredOracle(inputs), nullptr, nullptr,
                lightUnit());
  return comparison;
}

}  // namespace quell::tests

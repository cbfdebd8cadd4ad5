#include "tests/cases/low_confidence_case.hpp"

#include "kernels/common/guides.h"
#include "tests/cases/cell_planes.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {

LowConfidenceCase::LowConfidenceCase(const CaseOptions& options)
    : StageCase("low_confidence", makeEdagiSetup(options)),
      confidence(options.size, 2, 1.0f),
      guides(randomGuides({2, false}, options).guides) {
  Random random(options.seed);
  for (float& value : confidence.values)
    if (random.uniform() < 0.05) value = float(random.uniform());
}

void LowConfidenceCase::upload() {
  m_harness.upload("confidence", confidence);
  m_harness.upload("guides", guides);
}

Planes LowConfidenceCase::cells() const {
  return unpackCells(m_harness.download("cellConfidence"), confidenceCellsOf(size()), 1);
}

Comparison LowConfidenceCase::compare() {
  Comparison comparison;
  comparePixels(comparison, "least confidence", cells(),
                lowConfidenceOracle(confidence, planesOf(guides, QUELL_GUIDE_WEIGHT, 1)));
  return comparison;
}

}  // namespace quell::tests

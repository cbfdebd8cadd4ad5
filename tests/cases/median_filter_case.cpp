#include "tests/cases/median_filter_case.hpp"

#include "kernels/common/guides.h"
#include "tests/support/random_images.hpp"

namespace quell::tests {

MedianFilterCase::MedianFilterCase(const CaseOptions& options)
    : StageCase("median_filter", makeEdagiSetup(options)),
      irradiance(randomPlanes(options.size, 6, options.seed, 0.0, 8.0)),
      guides(randomGuides({2, false}, options).guides) {}

void MedianFilterCase::upload() {
  m_harness.upload("medianInput", irradiance);
  m_harness.upload("guides", guides);
}

Comparison MedianFilterCase::compare() {
  Comparison comparison(leftOut());
  comparePixels(comparison, "median", medians(),
                medianFilterOracle(planesOf(irradiance, 0, 3), planesOf(guides, QUELL_GUIDE_WEIGHT, 1)),
                leftOut(), nullptr, lightUnit());
  return comparison;
}

}  // namespace quell::tests

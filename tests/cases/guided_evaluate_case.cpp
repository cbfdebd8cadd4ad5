#include "tests/cases/guided_evaluate_case.hpp"

#include <algorithm>

#include "tests/cases/cell_planes.hpp"
#include "tests/oracle/guided_moments_oracle.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

constexpr double kUnusedShare = 0.1;  // of the cells
constexpr int kMostWindows = 25;

}  // namespace

GuidedEvaluateCase::GuidedEvaluateCase(const CaseOptions& options, const GuidedVariant& variant)
    : StageCase("guided_evaluate", makeGuidedSetup(options, variant)) {
  const FilterGuides guides = randomGuides({variant.signals, false}, options);
  inputs.guides = guides.guides;
  inputs.viewDepth = guides.viewDepth;
  inputs.subsampling = variant.subsampling;
  const Size cells = cellsOf(options.size, variant.subsampling);
  Planes& coefficients = inputs.windowCoefficients;
  coefficients = Planes(cells, QUELL_GUIDED_COEFFICIENTS * variant.signals);
  Random random(options.seed + 20);
  for (int first = 0; first < coefficients.count; first += QUELL_GUIDED_COEFFICIENTS) {
    forEachPixel(cells, [&](int x, int y) {
      const int windows = random.uniform() < kUnusedShare ? 0 : random.integer(1, kMostWindows);
      for (int k = 0; k < QUELL_GUIDED_USED; ++k)
        coefficients.at(first + k, x, y) = float(windows * random.uniform(-1.0, 3.0));
      coefficients.at(first + QUELL_GUIDED_USED, x, y) = float(windows);
    });
  }
}

void GuidedEvaluateCase::upload() {
  m_harness.upload("windowCoefficients", packCells(inputs.windowCoefficients));
  m_harness.upload("guides", inputs.guides);
  m_harness.upload("viewDepth", inputs.viewDepth);
}

Comparison GuidedEvaluateCase::compare() {
  Comparison comparison(leftOut());
  const Planes device = irradiance();
  const GuidedEvaluateExact exact = guidedEvaluateOracle(inputs);
  for (int plane = 0; plane < device.count; ++plane) {
    forEachPixel(size(), [&](int x, int y) {
      comparison.include("irradiance", plane, x, y, device.at(plane, x, y), exact.irradiance.at(plane, x, y),
                         std::max(1.0, exact.magnitudes.at(plane, x, y)));
    });
  }
  return comparison;
}

}  // namespace quell::tests

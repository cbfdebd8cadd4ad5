#include "tests/cases/sparse_bilateral_case.hpp"

#include <algorithm>

#include "tests/cases/cell_planes.hpp"
#include "tests/oracle/low_confidence_oracle.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

StageSetup makeSparseBilateralSetup(const CaseOptions& options, bool followsConfidence) {
  StageSetup setup = makeEdagiSetup(options, {1, false, false});
  setup.occurrence = followsConfidence ? 1 : 0;
  return setup;
}

}  // namespace

SparseBilateralCase::SparseBilateralCase(const CaseOptions& options, bool followsConfidence)
    : StageCase("sparse_bilateral", makeSparseBilateralSetup(options, followsConfidence)) {
  const Settings& settings = m_harness.configuration().settings;
  inputs.guides = randomGuides({1, false}, options);
  inputs.irradiance = randomPlanes(options.size, 3, options.seed + 10, 0.0, 8.0);
  inputs.stops = edgeStopsOf(settings);
  inputs.radius = settings.get(followsConfidence ? "radiusShare" : "historyRadiusShare") * options.size.width;
  inputs.lowFactor = settings.get("lowConfidenceFactor");
  if (!followsConfidence) return;
  inputs.cellConfidence = randomPlanes(confidenceCellsOf(options.size), 1, options.seed + 20);
  inputs.windowConfidence = inputs.cellConfidence;
  Random random(options.seed + 21);
  for (float& least : inputs.windowConfidence.values) least *= float(random.integer(0, 1));
}

void SparseBilateralCase::upload() {
  uploadGuides(m_harness, inputs.guides);
  m_harness.upload("sparseInput", inputs.irradiance);
  if (inputs.cellConfidence.count == 0) return;
  m_harness.upload("cellConfidence", packCells(inputs.cellConfidence));
  m_harness.upload("windowConfidence", packCells(inputs.windowConfidence));
}

Comparison SparseBilateralCase::compare() {
  Comparison comparison(leftOut());
  const SparseBilateralExact exact = sparseBilateralOracle(inputs);
  comparison.exclude(exact.undecided);
  comparePixels(comparison, "irradiance", filtered(), exact.irradiance, &exact.undecided, nullptr,
                lightUnit());
  return comparison;
}

}  // namespace quell::tests

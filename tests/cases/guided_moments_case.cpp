#include "tests/cases/guided_moments_case.hpp"

#include "kernels/guided_params.h"
#include "tests/cases/cell_planes.hpp"

namespace quell::tests {

GuidedMomentsCase::GuidedMomentsCase(const CaseOptions& options, const GuidedVariant& variant)
    : StageCase("guided_moments", makeGuidedSetup(options, variant)),
      inputs(guidedPixels(options, variant)) {}

void GuidedMomentsCase::upload() {
  m_harness.upload("irradiance", inputs.irradiance);
  m_harness.upload("guides", inputs.guides);
  m_harness.upload("viewDepth", inputs.viewDepth);
  uploadTapWeights(m_harness, inputs.guides);
}

Planes GuidedMomentsCase::moments() const {
  return unpackCells(m_harness.download("moments"), cellsOf(size(), inputs.subsampling),
                     QUELL_GUIDED_SUMS * inputs.signals());
}

Comparison GuidedMomentsCase::compare() {
  Comparison comparison;
  const Planes device = moments();
  const GuidedMomentsExact exact = guidedMomentsOracle(inputs);
  for (int plane = 0; plane < device.count; ++plane) {
    forEachPixel(device.size(), [&](int x, int y) {
      const double magnitude = exact.magnitudes.at(plane, x, y);
      // What nothing was added to must be 0.
      comparison.include("moment", plane, x, y, device.at(plane, x, y), exact.sums.at(plane, x, y),
                         magnitude > 0.0 ? magnitude : 1.0);
    });
  }
  return comparison;
}

}  // namespace quell::tests

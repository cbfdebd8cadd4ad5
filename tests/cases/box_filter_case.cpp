#include "tests/cases/box_filter_case.hpp"

#include "kernels/guided_params.h"
#include "tests/cases/cell_planes.hpp"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

StageSetup makeBoxFilterSetup(const CaseOptions& options, BoxPass pass, const GuidedVariant& variant) {
  StageSetup setup = makeGuidedSetup(options, variant);
  setup.occurrence = static_cast<int>(pass);
  return setup;
}

bool ofMoments(BoxPass pass) { return pass == BoxPass::MomentColumns || pass == BoxPass::MomentRows; }
bool alongRows(BoxPass pass) { return pass == BoxPass::MomentRows || pass == BoxPass::CoefficientRows; }

}  // namespace

BoxFilterCase::BoxFilterCase(const CaseOptions& options, BoxPass pass, const GuidedVariant& variant)
    : StageCase("box_filter", makeBoxFilterSetup(options, pass, variant)),
      m_pass(pass),
      m_radius(guidedCellRadius(variant.subsampling)) {
  const int planes = (ofMoments(pass) ? QUELL_GUIDED_SUMS : QUELL_GUIDED_COEFFICIENTS) * variant.signals;
  input = randomPlanes(cellsOf(options.size, variant.subsampling), planes, options.seed, -4.0, 4.0);
}

void BoxFilterCase::upload() { m_harness.upload("boxInput", packCells(input)); }

Planes BoxFilterCase::sums() const {
  return unpackCells(m_harness.download("boxOutput"), input.size(), input.count);
}

Comparison BoxFilterCase::compare() {
  Comparison comparison;
  const Planes device = sums();
  const BoxFilterExact exact = boxFilterOracle(input, m_radius, alongRows(m_pass));
  for (int plane = 0; plane < device.count; ++plane) {
    forEachPixel(device.size(), [&](int x, int y) {
      comparison.include("sum", plane, x, y, device.at(plane, x, y), exact.sums.at(plane, x, y),
                         exact.magnitudes.at(plane, x, y));
    });
  }
  return comparison;
}

}  // namespace quell::tests

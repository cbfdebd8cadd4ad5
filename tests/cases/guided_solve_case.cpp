#include "tests/cases/guided_solve_case.hpp"

#include <algorithm>

#include "tests/cases/cell_planes.hpp"
#include "tests/oracle/box_filter_oracle.hpp"

namespace quell::tests {
namespace {

constexpr double kLeastBrightness = 1e-3;  // share of the light's unit below which errors are absolute

Planes rounded(const ExactPlanes& exact) {
  Planes planes(exact.size(), exact.count);
  std::transform(exact.values.begin(), exact.values.end(), planes.values.begin(),
                 [](double value) { return float(value); });
  return planes;
}

Planes sumWindows(const Planes& cells, int radius) {
  return rounded(boxFilterOracle(rounded(boxFilterOracle(cells, radius, false).sums), radius, true).sums);
}

}  // namespace

GuidedSolveCase::GuidedSolveCase(const CaseOptions& options, const GuidedVariant& variant)
    : StageCase("guided_solve", makeGuidedSetup(options, variant)), pixels(guidedPixels(options, variant)) {
  m_inputs.epsilon = kGuidedEpsilon;
}

void GuidedSolveCase::upload() {
  m_inputs.windowMoments =
      sumWindows(rounded(guidedMomentsOracle(pixels).sums), guidedCellRadius(pixels.subsampling));
  m_harness.upload("windowMoments", packCells(m_inputs.windowMoments));
}

Planes GuidedSolveCase::coefficients() const {
  return unpackCells(m_harness.download("coefficients"), cellsOf(size(), pixels.subsampling),
                     QUELL_GUIDED_COEFFICIENTS * pixels.signals());
}

void GuidedSolveCase::compareWindow(Comparison& comparison, const Planes& device, const GuidedFit& fit,
                                    int signal, int x, int y) const {
  const int first = QUELL_GUIDED_COEFFICIENTS * signal;
  comparison.include("used", signal, x, y, device.at(first + QUELL_GUIDED_USED, x, y), fit.used ? 1.0 : 0.0);
  GuidedCoefficients found;
  for (int j = 0; j < QUELL_GUIDED_FEATURES; ++j)
    for (int c = 0; c < QUELL_GUIDED_CHANNELS; ++c)
      found(j, c) = device.at(first + QUELL_GUIDED_CHANNELS * j + c, x, y);
  for (int away = 0; away < QUELL_GUIDED_FEATURES; ++away) {
    GuidedColumns guides = fit.mean;
    if (away > 0) guides[away] += fit.deviation[away];
    const Eigen::RowVector3d wanted = guides.transpose() * fit.coefficients;
    const Eigen::RowVector3d got = guides.transpose() * found;
    for (int c = 0; c < QUELL_GUIDED_CHANNELS; ++c)
      comparison.include("prediction of signal " + std::to_string(signal), away, x, y, got[c], wanted[c],
                         std::max(kLeastBrightness * lightUnit(), fit.brightness));
  }
}

Comparison GuidedSolveCase::compare() {
  Comparison comparison;
  const Planes device = coefficients();
  const std::vector<GuidedFit> fits = guidedSolveOracle(m_inputs);
  auto fit = fits.begin();
  for (int signal = 0; signal < pixels.signals(); ++signal) {
    forEachPixel(device.size(), [&](int x, int y) {
      if (fit->undecided) {
        comparison.exclude();
      } else {
        compareWindow(comparison, device, *fit, signal, x, y);
      }
      ++fit;
    });
  }
  return comparison;
}

}  // namespace quell::tests

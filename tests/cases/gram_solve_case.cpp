#include "tests/cases/gram_solve_case.hpp"

#include <algorithm>

namespace quell::tests {
namespace {

constexpr double kLeastScale = 1e-3;  // share of the light's unit below which errors are absolute

double brightest(const Planes& irradiance, const std::vector<BlockPixel>& pixels, double unit) {
  double brightest = kLeastScale * unit;
  for (const BlockPixel p : pixels)
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      brightest = std::max<double>(brightest, irradiance.at(c, p.x, p.y));
  return brightest;
}

}  // namespace

GramSolveCase::GramSolveCase(const CaseOptions& options, GramWindows windows, double noiseAmplitude)
    : StageCase("gram_solve", makeGramSetup(options, windows, noiseAmplitude)),
      inputs(makeGramInputs(options, windows)),
      m_windows(windows),
      m_noiseAmplitude(noiseAmplitude),
      m_list(namesOf(FitFeatures(options.features))) {
  useFrame(1);
}

void GramSolveCase::useFrame(std::uint32_t frameIndex) {
  m_frameIndex = frameIndex;
  inputs.params = makeGramParams(m_windows, size(), frameIndex, m_noiseAmplitude);
}

void GramSolveCase::upload() {
  m_uploaded = tiles.values.empty() ? packTiles(gramSumsOracle(inputs)) : tiles;
  m_harness.upload("gramTiles", m_uploaded);
}

Comparison GramSolveCase::compare() { return comparePredictions(gramSolveOracle(solveInputs())); }

Comparison GramSolveCase::comparePixels() const {
  std::vector<GramFit> fits;
  for (int window = 0; window < gramTileCount(inputs.params); ++window)
    fits.push_back(ridgeFit(windowOfPixels(inputs, window), m_list, double(inputs.params.noiseVariance)));
  return comparePredictions(fits);
}

Comparison GramSolveCase::compareRecords(const Planes& others, double leastWeight) const {
  std::vector<GramFit> fits(std::size_t(gramTileCount(inputs.params)));
  for (int window = 0; window < int(fits.size()); ++window) {
    GramFit& fit = fits[std::size_t(window)];
    fit.record = unpackRecord(others, window, m_list);
    fit.undecided = windowOfTiles(solveInputs(), window).sums(0, 0) < leastWeight;
  }
  return comparePredictions(fits);
}

Comparison GramSolveCase::compareCoefficients() const {
  Comparison comparison;
  const std::vector<GramFit> exact = gramSolveOracle(solveInputs());
  const Planes device = records();
  for (int window = 0; window < int(exact.size()); ++window) {
    const GramFit& fit = exact[std::size_t(window)];
    if (fit.undecided || fit.condition > kGramWellConditioned) {
      comparison.exclude();
      continue;
    }
    const FitRecord record = unpackRecord(device, window, m_list);
    const Coefficients& expected = fit.record.coefficients;
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      for (int j = 0; j < m_list.count(); ++j)
        comparison.include("coefficient (feature, channel) of window " + std::to_string(window), 0, j, c,
                           record.coefficients(j, c), expected(j, c),
                           std::max(kLeastScale * lightUnit(), expected.col(c).cwiseAbs().maxCoeff()));
  }
  return comparison;
}

Comparison GramSolveCase::comparePredictions(const std::vector<GramFit>& exact) const {
  Comparison comparison;
  const Planes device = records();
  for (int window = 0; window < int(exact.size()); ++window) {
    const GramFit& fit = exact[std::size_t(window)];
    if (fit.undecided) {
      comparison.exclude();
      continue;
    }
    const FitRecord record = unpackRecord(device, window, m_list);
    const std::vector<BlockPixel> pixels = windowPixels(window);
    const double scale = brightest(inputs.irradiance, pixels, lightUnit());
    const std::string name = "prediction of window " + std::to_string(window) + " (condition " +
                             std::to_string(int(fit.condition)) + ")";
    for (const BlockPixel p : pixels) {
      const Eigen::RowVector3d predicted = features(inputs.guides, record, p.x, p.y) * record.coefficients;
      const Eigen::RowVector3d wanted =
          features(inputs.guides, fit.record, p.x, p.y) * fit.record.coefficients;
      for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
        comparison.include(name, c, p.x, p.y, predicted[c], wanted[c], scale);
    }
  }
  return comparison;
}

std::vector<BlockPixel> GramSolveCase::windowPixels(int window) const {
  std::vector<BlockPixel> pixels;
  for (const WindowTile& part : windowTiles(inputs.params, inputs.overlap, window)) {
    const std::vector<BlockPixel> more = tilePixels(inputs, part.tile);
    pixels.insert(pixels.end(), more.begin(), more.end());
  }
  return pixels;
}

}  // namespace quell::tests

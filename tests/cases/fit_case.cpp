#include "tests/cases/fit_case.hpp"

#include <algorithm>

#include "kernels/accumulate_noisy_params.h"
#include "tests/cases/feature_inputs.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

constexpr double kLeastScale = 1e-3;  // share of the light's unit below which errors are absolute

StageSetup makeFitSetup(const CaseOptions& options, FeatureStorage storage, double noiseAmplitude) {
  StageSetup setup = makeSetup(options);
  setup.settings.set("featureStorage", storage == FeatureStorage::Half ? "half" : "float");
  setup.settings.set("noiseAmplitude", noiseAmplitude);
  return setup;
}

double brightest(const FitInputs& inputs, int block, double unit) {
  double brightest = kLeastScale * unit;
  for (int row = 0; row < QUELL_BLOCK_PIXELS; ++row) {
    const BlockPixel pixel = blockPixel(inputs.params, block, row);
    if (!(inputs.guides.at(QUELL_GUIDE_WEIGHT, pixel.x, pixel.y) > 0.0f)) continue;
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      brightest = std::max<double>(brightest, inputs.irradiance.at(c, pixel.x, pixel.y));
  }
  return brightest;
}

}  // namespace

FitCase::FitCase(const CaseOptions& options, FeatureStorage storage, double noiseAmplitude)
    : StageCase("fit", makeFitSetup(options, storage, noiseAmplitude)),
      m_storage(storage),
      m_features(options.features) {
  inputs.list = namesOf(m_features);
  m_reprojection.viewDepth = viewAxisOf(inputs.list);
  inputs.irradiance = randomPlanes(options.size, 3, options.seed, 0.0, 8.0);
  inputs.guides = withMaterials(renderScene({}, options.size, 1, options.holes()).guides, options.seed + 2);
  Random random(options.seed + 1);
  forEachPixel(options.size, [&](int x, int y) {
    if (random.uniform() < 0.1) inputs.guides.at(QUELL_GUIDE_WEIGHT, x, y) *= float(random.uniform());
  });
  inputs.params.noiseAmplitude = float(noiseAmplitude);
  useFrame(1);
}

void FitCase::useRandomFeatures(unsigned seed) {
  inputs.guides = randomPlanes(size(), kGuideAndMaterialPlanes, seed, -1.0, 1.0);
  forEachPixel(size(), [&](int x, int y) { inputs.guides.at(QUELL_GUIDE_WEIGHT, x, y) = 1.0f; });
}

void FitCase::useFrame(std::uint32_t frameIndex) {
  m_frameIndex = frameIndex;
  inputs.params = makeFitParams(size(), frameIndex, inputs.params.noiseAmplitude);
}

void FitCase::upload() {
  m_harness.upload("irradiance", inputs.irradiance);
  m_harness.upload("guides", inputs.guides);
  uploadTapWeights(m_harness, inputs.guides);
  if (m_features.needMaterial()) m_harness.upload("materials", materialsOf(inputs.guides));
}

Comparison FitCase::compare() {
  Comparison comparison;
  const FitExact exact = fitOracle(inputs);
  const Planes device = records();
  for (int block = 0; block < int(exact.records.size()); ++block) {
    const FitRecord record = unpackRecord(device, block, inputs.list);
    const FitRecord& expected = exact.records[std::size_t(block)];
    const double scale = brightest(inputs, block, lightUnit());
    bool anyWeight = false;
    for (int row = 0; row < QUELL_BLOCK_PIXELS; ++row) {
      const BlockPixel p = blockPixel(inputs.params, block, row);
      if (!(inputs.guides.at(QUELL_GUIDE_WEIGHT, p.x, p.y) > 0.0f)) continue;
      anyWeight = true;
      const Eigen::RowVector3d predicted = features(inputs.guides, record, p.x, p.y) * record.coefficients;
      const Eigen::RowVector3d wanted = features(inputs.guides, expected, p.x, p.y) * expected.coefficients;
      for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
        comparison.include("prediction of block " + std::to_string(block), c, p.x, p.y, predicted[c],
                           wanted[c], scale);
    }
    comparison.include("whether a fit is usable, of block", block, 0, 0, record.usable, anyWeight);
  }
  return comparison;
}

Comparison FitCase::compareCoefficients() const {
  Comparison comparison;
  const FitExact exact = fitOracle(inputs);
  const Planes device = records();
  for (int block = 0; block < int(exact.records.size()); ++block) {
    if (exact.conditions[std::size_t(block)] > kFitWellConditioned) {
      comparison.exclude();
      continue;
    }
    const FitRecord record = unpackRecord(device, block, inputs.list);
    const Coefficients& expected = exact.records[std::size_t(block)].coefficients;
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
      for (int j = 0; j < inputs.list.count(); ++j)
        comparison.include("coefficient (feature, channel) of block " + std::to_string(block), 0, j, c,
                           record.coefficients(j, c), expected(j, c), expected.col(c).cwiseAbs().maxCoeff());
  }
  return comparison;
}

}  // namespace quell::tests

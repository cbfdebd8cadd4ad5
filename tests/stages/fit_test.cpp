#include <algorithm>

#include "kernels/accumulate_noisy_params.h"
#include "kernels/common/reprojection_params.h"
#include "tests/cases/fit_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseOptions makeOptions(Size size, Mapping mapping, int fitGroup) {
  CaseOptions options;
  options.size = size;
  options.mapping = mapping;
  options.fitGroup = fitGroup;
  return options;
}

// One work-item and sixteen lanes a block, as on CPUs, and shared blocks, as on GPUs.
const std::vector<std::pair<Mapping, int>>& fitVariants() {
  static const std::vector<std::pair<Mapping, int>> variants = {
      {Mapping::Wide, 1}, {Mapping::Narrow, 32}, {Mapping::Narrow, 64}, {Mapping::Narrow, 256}};
  return variants;
}

// Largest error of the noise-free predictions, irradiance being the same everywhere.
double constantError(FitCase& fit, float value) {
  std::fill(fit.inputs.irradiance.values.begin(), fit.inputs.irradiance.values.end(), value);
  fit.uploadAndRun();
  const Planes records = fit.records();
  double largest = 0.0;
  for (int block = 0; block < blockCount(fit.size()); ++block) {
    const FitRecord record = unpackRecord(records, block);
    for (int row = 0; row < QUELL_BLOCK_PIXELS; ++row) {
      const BlockPixel p = blockPixel(fit.inputs.params, block, row);
      if (fit.inputs.guides.at(QUELL_GUIDE_WEIGHT, p.x, p.y) == 0.0f) continue;
      const Eigen::RowVector3d predicted =
          features(fit.inputs.guides, record, p.x, p.y) * record.coefficients;
      largest = std::max(largest, (predicted.array() - double(value)).abs().maxCoeff() / double(value));
    }
  }
  return largest;
}

// A flat surface: its range along the view is a vanishing share of the distance, but large in itself.
void useDistantSurface(Planes& guides, float distance) {
  Random random(4);
  forEachPixel(guides.size(), [&](int x, int y) {
    const double position[3] = {0.01 * x * distance, 0.01 * y * distance,
                                -distance * (1.0 + 5e-5 * random.uniform())};
    for (int axis = 0; axis < 3; ++axis) guides.at(QUELL_GUIDE_POSITION + axis, x, y) = float(position[axis]);
  });
}

}  // namespace

TEST_CASE("fit agrees with its oracle on sixteen lanes") {
  for (const Size size : testSizes()) {
    const CaseOptions options = makeOptions(size, Mapping::Wide, 1);
    FitCase fit(options);
    checkAgreement(fit, options);
  }
}

TEST_CASE("fit agrees with its oracle in shared blocks") {
  for (const int group : {32, 64, 256}) {
    for (const Size size : {Size{1, 1}, Size{7, 93}, Size{257, 89}}) {
      const CaseOptions options = makeOptions(size, Mapping::Narrow, group);
      FitCase fit(options);
      checkAgreement(fit, options);
    }
  }
}

TEST_CASE("fit leaves out blocks of background") {
  static constexpr double kNoise = 0.1;  // keeps blocks of a few pixels well-conditioned
  checkHoles([](const CaseOptions& options) {
    return std::make_unique<FitCase>(options, FeatureStorage::Float, kNoise);
  });
}

TEST_CASE("fit with half storage agrees with its oracle") {
  for (const auto& [mapping, group] : {std::pair(Mapping::Wide, 1), std::pair(Mapping::Narrow, 256)}) {
    const CaseOptions options = makeOptions({77, 43}, mapping, group);
    FitCase fit(options, FeatureStorage::Half);
    checkAgreement(fit, options);
  }
}

TEST_CASE("fit finds the oracle's coefficients where the problem is well-conditioned") {
  for (const auto& [mapping, group] : fitVariants()) {
    FitCase fit(makeOptions({77, 43}, mapping, group));
    fit.useRandomFeatures(5);
    fit.uploadAndRun();
    const Comparison comparison = fit.compareCoefficients();
    INFO(comparison.worst());
    CHECK(comparison.compared() > 0);
    CHECK(comparison.largestError() <= kFitCoefficientTolerance);
  }
}

TEST_CASE("fit agrees with its oracle at all offsets of the grid") {
  const CaseOptions options = makeOptions({65, 34}, Mapping::Wide, 1);
  FitCase fit(options);
  for (std::uint32_t frame = 0; frame < 16; ++frame) {
    fit.useFrame(frame);
    INFO("frame " << frame);
    checkAgreement(fit, options);
  }
}

TEST_CASE("fit without noise leaves dependent features out") {
  for (const auto& [mapping, group] : fitVariants()) {
    const CaseOptions options = makeOptions({77, 43}, mapping, group);
    FitCase fit(options, FeatureStorage::Float, 0.0);
    // A floor: the normal is constant, the height too.
    forEachPixel(options.size, [&](int x, int y) {
      const float guides[QUELL_GUIDE_PLANES_OF(1)] = {
          float(x) * 0.1f, -2.0f, -5.0f - float(y) * 0.1f, 0, 1, 0, 1};
      for (int plane = 0; plane < QUELL_GUIDE_PLANES_OF(1); ++plane)
        fit.inputs.guides.at(plane, x, y) = guides[plane];
    });
    checkAgreement(fit, options);
    CHECK(allFinite(fit.records()));
  }
}

TEST_CASE("fit with few or no usable pixels in a block stays finite and agrees with its oracle") {
  for (const auto& [mapping, group] : fitVariants()) {
    const CaseOptions options = makeOptions({77, 43}, mapping, group);
    FitCase fit(options);
    Random random(3);
    forEachPixel(options.size, [&](int x, int y) {
      if (x < 40 || random.uniform() > 0.004) fit.inputs.guides.at(QUELL_GUIDE_WEIGHT, x, y) = 0.0f;
    });
    checkAgreement(fit, options);
    CHECK(allFinite(fit.records()));
  }
}

TEST_CASE("fit returns a constant") {
  for (const auto& [mapping, group] : fitVariants()) {
    FitCase fit(makeOptions({77, 43}, mapping, group));
    CHECK(constantError(fit, 3.25f) <= kFitTolerance);
    CHECK(constantError(fit, QUELL_MAX_RADIANCE) <= kFitTolerance);
  }
}

TEST_CASE("fit far from the camera agrees with its oracle") {
  for (const float distance : {1e3f, 1e9f}) {
    const CaseOptions options = makeOptions({77, 43}, Mapping::Wide, 1);
    FitCase fit(options);
    useDistantSurface(fit.inputs.guides, distance);
    INFO("distance " << distance);
    checkAgreement(fit, options);
  }
}

// Positions whose range is rounding noise are divided by the distance: only shifted, their squares
// overflowed.
TEST_CASE("fit stays finite up to the largest position", "[stages]") {
  FitCase fit(makeOptions({77, 43}, Mapping::Wide, 1));
  useDistantSurface(fit.inputs.guides, 0.1f * QUELL_MAX_POSITION);
  fit.uploadAndRun();
  CHECK(allFinite(fit.records()));
}

TEST_CASE("fit of the brightest noise stays finite with either storage") {
  for (const FeatureStorage storage : {FeatureStorage::Float, FeatureStorage::Half}) {
    FitCase fit(makeOptions({77, 43}, Mapping::Wide, 1), storage);
    Random random(6);
    for (float& value : fit.inputs.irradiance.values)
      value = random.uniform() < 0.5 ? 0.0f : QUELL_MAX_RADIANCE;
    fit.uploadAndRun();
    CHECK(allFinite(fit.records()));
  }
}

TEST_CASE("fit gives the same bits whatever the work-group and the number of lanes") {
  // All add in the order of 256 logical lanes, so sixteen lanes and shared blocks agree as well.
  Planes first;
  auto variants = fitVariants();
  variants.insert(variants.end(), {{Mapping::Wide, 4}, {Mapping::Wide, 16}});
  for (const auto& [mapping, group] : variants) {
    const CaseOptions options = makeOptions({77, 43}, mapping, group);
    FitCase fit(options);
    fit.uploadAndRun();
    if (first.values.empty()) first = fit.records();
    INFO(describe(options));
    CHECK(sameBits(first, fit.records()));
  }
}

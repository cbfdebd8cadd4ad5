#include <algorithm>

#include "kernels/accumulate_noisy_params.h"
#include "tests/cases/fit_case.hpp"
#include "tests/cases/gram_solve_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

/// What regularisation takes from a signal that is linear in the features, relative to the window's
/// brightest irradiance: noise of variance 3e-5 next to features whose variance is 1e-2 to 1e-1.
constexpr double kRidgeBias = 0.005;
/// Of the same without noise, where only rounding is left, and dependent features are left out.
constexpr double kExactTolerance = 1e-4;
/// Between the solvers without noise: predictions by normal equations lose twice the digits.
constexpr double kSolversTolerance = 1e-4;
constexpr double kNoise = 0.01;  // scaled feature units
constexpr double kAboveRounding = 1.0001;
constexpr int kFewPixels = 12;

constexpr GramWindows kAllWindows[] = {kBlocks, kOverlap8, kOverlap16};

CaseOptions makeOptions(Size size, Mapping mapping, int fitGroup = 0) {
  CaseOptions options;
  options.size = size;
  options.mapping = mapping;
  options.fitGroup = fitGroup;
  return options;
}

std::string describe(const GramWindows& windows) {
  return (windows.overlap ? "overlapping windows of tiles of " : "blocks of ") +
         std::to_string(windows.tileEdge);
}

void checkPixels(GramSolveCase& solve) {
  const Comparison comparison = solve.comparePixels();
  INFO("straight from the pixels: " << comparison.worst());
  CHECK(comparison.compared() > 0);
  CHECK(comparison.largestError() <= kGramPixelsTolerance);
}

// Runs gram_sums and gram_solve on the device, for the pixels of `solve`.
void runBoth(GramSolveCase& solve, const CaseOptions& options, const GramWindows& windows) {
  GramSumsCase sums(options, windows);
  sums.inputs = solve.inputs;
  sums.uploadAndRun();
  solve.tiles = sums.tiles();
  solve.uploadAndRun();
}

// Records that predict `value` everywhere.
Planes constantRecords(const GramParams& params, float value) {
  FitRecord record;
  record.coefficients.row(0).setConstant(double(value));
  return packRecords(std::vector<FitRecord>(std::size_t(gramTileCount(params)), record));
}

// Sets the irradiance to what an unscaled record predicts, which every window can reproduce; returns the
// record.
FitRecord useLinearSignal(GramInputs& inputs) {
  FitRecord record;
  record.coefficients.col(0) << 6.0, 1.0, -0.5, 0.5, 0.4, -0.3, 0.2, 0.03, 0.02, -0.01;
  record.coefficients.col(1) << 5.0, -1.0, 0.25, 0.5, -0.2, 0.1, 0.3, 0.01, -0.02, 0.02;
  record.coefficients.col(2) << 7.0, 0.5, 0.5, -1.0, 0.1, 0.2, -0.1, -0.02, 0.01, 0.01;
  forEachPixel(inputs.guides.size(), [&](int x, int y) {
    const Eigen::RowVector3d color = features(inputs.guides, record, x, y) * record.coefficients;
    for (int c = 0; c < QUELL_FIT_CHANNELS; ++c) inputs.irradiance.at(c, x, y) = float(color[c]);
  });
  return record;
}

double linearError(const GramWindows& windows, Mapping mapping, bool randomFeatures, double noise) {
  const CaseOptions options = makeOptions({77, 43}, mapping);
  GramSolveCase solve(options, windows, noise);
  if (randomFeatures) useRandomFeatures(solve.inputs.guides, 9);
  const FitRecord record = useLinearSignal(solve.inputs);
  runBoth(solve, options, windows);
  const std::vector<FitRecord> same(std::size_t(gramTileCount(solve.inputs.params)), record);
  // Windows with less weight get their mean alone.
  const Comparison comparison =
      solve.compareRecords(packRecords(same), double(QUELL_GRAM_LEAST_WEIGHT) * kAboveRounding);
  INFO(comparison.worst());
  CHECK(comparison.compared() > 0);
  return comparison.largestError();
}

// Leaves `count` pixels their weight, at random places.
void keepPixels(Planes& guides, int count, unsigned seed) {
  forEachPixel(guides.size(), [&](int x, int y) { guides.at(QUELL_GUIDE_WEIGHT, x, y) = 0.0f; });
  Random random(seed);
  for (int kept = 0; kept < count;) {
    float& weight = guides.at(QUELL_GUIDE_WEIGHT, random.integer(0, guides.width - 1),
                              random.integer(0, guides.height - 1));
    if (weight == 0.0f) ++kept;
    weight = 1.0f;
  }
}

Planes recordsOf(const CaseOptions& options, const GramWindows& windows) {
  GramSolveCase solve(options, windows);
  solve.uploadAndRun();
  return solve.records();
}

}  // namespace

TEST_CASE("gram_solve agrees with its oracle") {
  for (const GramWindows& windows : kAllWindows) {
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      for (const Size size : {Size{1, 1}, Size{7, 93}, Size{33, 31}, Size{257, 89}}) {
        const CaseOptions options = makeOptions(size, mapping);
        GramSolveCase solve(options, windows);
        INFO(describe(windows));
        checkAgreement(solve, options);
        checkPixels(solve);
      }
    }
  }
}

TEST_CASE("gram_solve agrees with its oracle on a whole picture") {
  for (const GramWindows& windows : kAllWindows) {
    const CaseOptions options = makeOptions({480, 270}, Mapping::Wide);
    GramSolveCase solve(options, windows);
    INFO(describe(windows));
    checkAgreement(solve, options);
  }
}

TEST_CASE("gram_solve agrees with its oracle at all offsets of the grid") {
  for (const GramWindows& windows : kAllWindows) {
    const CaseOptions options = makeOptions({65, 34}, Mapping::Wide);
    GramSolveCase solve(options, windows);
    for (std::uint32_t frame = 0; frame < 16; ++frame) {
      solve.useFrame(frame);
      INFO(describe(windows) << ", frame " << frame);
      checkAgreement(solve, options);
      checkPixels(solve);
    }
  }
}

TEST_CASE("gram_solve finds the oracle's coefficients where the problem is well-conditioned") {
  for (const GramWindows& windows : kAllWindows) {
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      for (const double noise : {0.0, kNoise}) {
        GramSolveCase solve(makeOptions({77, 43}, mapping), windows, noise);
        useRandomFeatures(solve.inputs.guides, 5);
        solve.uploadAndRun();
        const Comparison comparison = solve.compareCoefficients();
        INFO(describe(windows) << ", noise " << noise << ": " << comparison.worst());
        CHECK(comparison.compared() > 0);
        CHECK(comparison.largestError() <= kGramCoefficientTolerance);
      }
    }
  }
}

TEST_CASE("gram_sums and gram_solve return a constant") {
  for (const GramWindows& windows : kAllWindows) {
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      for (const float value : {3.25f, QUELL_MAX_RADIANCE}) {
        const CaseOptions options = makeOptions({77, 43}, mapping);
        GramSolveCase solve(options, windows);
        std::fill(solve.inputs.irradiance.values.begin(), solve.inputs.irradiance.values.end(), value);
        runBoth(solve, options, windows);
        const Comparison comparison = solve.compareRecords(constantRecords(solve.inputs.params, value));
        INFO(describe(windows) << ": " << comparison.worst());
        CHECK(comparison.compared() > 0);
        CHECK(comparison.largestError() <= kGramSolveTolerance);
      }
    }
  }
}

TEST_CASE("gram_sums and gram_solve reproduce what is linear in the features") {
  for (const GramWindows& windows : kAllWindows) {
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      INFO(describe(windows) << ", " << toString(mapping));
      CHECK(linearError(windows, mapping, false, kNoise) <= kRidgeBias);
      CHECK(linearError(windows, mapping, true, kNoise) <= kRidgeBias);
      CHECK(linearError(windows, mapping, true, 0.0) <= kExactTolerance);
    }
  }
}

TEST_CASE("gram_sums and gram_solve without any weight give records that predict 0") {
  for (const GramWindows& windows : kAllWindows) {
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      const CaseOptions options = makeOptions({77, 43}, mapping);
      GramSolveCase solve(options, windows);
      keepPixels(solve.inputs.guides, 0, 1);
      runBoth(solve, options, windows);
      const Planes records = solve.records();
      CHECK(allFinite(records));
      for (int window = 0; window < gramTileCount(solve.inputs.params); ++window)
        CHECK(unpackRecord(records, window).coefficients.isZero(0.0));
    }
  }
}

TEST_CASE("gram_sums and gram_solve of few pixels stay finite and agree with the oracle") {
  for (const GramWindows& windows : kAllWindows) {
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      // The smaller image is mirrored into a block again and again, so its few pixels have a large weight.
      for (const Size size : {Size{7, 5}, Size{45, 37}}) {
        const CaseOptions options = makeOptions(size, mapping);
        GramSolveCase solve(options, windows);
        for (int count = 1; count <= kFewPixels; ++count) {
          keepPixels(solve.inputs.guides, count, unsigned(count));
          runBoth(solve, options, windows);
          const Comparison comparison = solve.compare();
          INFO(describe(windows) << ", " << count << " pixels: " << comparison.worst());
          CHECK(allFinite(solve.records()));
          CHECK(comparison.largestError() <= kGramSolveTolerance);
        }
      }
    }
  }
}

TEST_CASE("gram_sums and gram_solve agree with the stage fit without noise") {
  const CaseOptions options = makeOptions({77, 43}, Mapping::Wide, 1);
  GramSolveCase solve(options, kBlocks, 0.0);
  useRandomFeatures(solve.inputs.guides, 5);
  runBoth(solve, options, kBlocks);
  FitCase fit(options, FeatureStorage::Float, 0.0);
  fit.inputs.irradiance = solve.inputs.irradiance;
  fit.inputs.guides = solve.inputs.guides;
  fit.uploadAndRun();
  const Comparison comparison = solve.compareRecords(fit.records());
  INFO(comparison.worst());
  CHECK(comparison.compared() > 0);
  CHECK(comparison.largestError() <= kSolversTolerance);
}

TEST_CASE("gram_solve gives the same bits whatever the work-group, and again") {
  for (const GramWindows& windows : kAllWindows) {
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      CaseOptions options = makeOptions({77, 43}, mapping);
      const Planes first = recordsOf(options, windows);
      CHECK(sameBits(first, recordsOf(options, windows)));
      options.workGroup = {16, 4};
      options.fitGroup = 32;
      CHECK(sameBits(first, recordsOf(options, windows)));
    }
  }
}

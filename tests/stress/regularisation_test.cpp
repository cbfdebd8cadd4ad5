// Stochastic regularisation and its closed form: noise of variance epsilon^2 / 3 on the features adds a ridge
// of that height, times the sum of weights, to the expected Gram matrix. The solutions are only close.
#include <Eigen/Cholesky>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/stress/test_fitter.hpp"

namespace quell::stress {
namespace {

using GramMatrix = Eigen::Matrix<double, QUELL_FEATURES, QUELL_FEATURES>;

constexpr double kAmplitude = 0.01;
constexpr double kVariance = kAmplitude * kAmplitude / 3.0;
constexpr std::uint32_t kSeeds = 1000;
// An average of a thousand seeds is this many standard errors from its expectation at most, with 100
// elements.
constexpr double kStandardErrors = 5.0;
// Predictions of the mean over seeds from gram's, RMS per deviation of the signal: up to 6e-4 was measured,
// of which an average of a thousand seeds alone accounts for 5e-4 (a single seed: 0.008 to 0.017).
constexpr double kMostMeanDifference = 2e-3;
constexpr double kMostShareOfOne = 0.1;
// Of elements that do not vary, absolute.
constexpr double kRounding = 1e-9;

// The generator of kernels/common/random.h: PCG-RXS-M-XS (Jarzynski and Olano 2020).
std::uint32_t hash(std::uint32_t v) {
  const std::uint32_t state = v * 747796405u + 2891336453u;
  const std::uint32_t word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

// N of kernels/fit.cl for a block in which every pixel has a weight.
FeatureMatrix noiseMatrix(std::uint32_t seed) {
  FeatureMatrix noise = FeatureMatrix::Zero(kBlockPixels, QUELL_FEATURES);
  for (int row = 0; row < kBlockPixels; ++row)
    for (int k = 1; k < QUELL_FEATURES; ++k) {
      const std::uint32_t bits = hash(static_cast<std::uint32_t>(row + k * kBlockPixels) ^ hash(seed));
      noise(row, k) = kAmplitude * std::ldexp(static_cast<double>(static_cast<std::int32_t>(bits)), -31);
    }
  return noise;
}

class MatrixMean {
 public:
  void add(const GramMatrix& matrix) {
    m_sum += matrix;
    m_sumOfSquares += matrix.cwiseAbs2();
    m_count += 1.0;
  }
  /// Largest difference of the mean from `expected`, in standard errors.
  double deviation(const GramMatrix& expected) const {
    return (m_sum / m_count - expected).cwiseQuotient(standardErrors()).cwiseAbs().maxCoeff();
  }
  double largestStandardError() const { return standardErrors().maxCoeff(); }

 private:
  GramMatrix standardErrors() const {
    const GramMatrix variance = m_sumOfSquares / m_count - (m_sum / m_count).cwiseAbs2();
    return (variance.cwiseMax(0.0) / m_count).cwiseSqrt().cwiseMax(kRounding);
  }

  GramMatrix m_sum = GramMatrix::Zero();
  GramMatrix m_sumOfSquares = GramMatrix::Zero();
  double m_count = 0.0;
};

struct Example {
  LeastSquares problem;
  std::vector<BlockFit> householder;  // one a seed
  BlockFit gram;
};

Example makeExample(const std::string& family, std::uint32_t seeds) {
  Batch batch = makeBatch(findFamily(family), 9, 0, 1);
  batch.blocks.resize(seeds, batch.blocks[0]);
  const BatchFit fits = sharedFitter().fit(batch, 1000);
  return {makeLeastSquares(fits.inputs[0], fits.gram[0]), fits.householder, fits.gram[0]};
}

// Least squares with `ridge` times the sum of weights on the diagonal of the Gram matrix, constant feature
// excepted.
Coefficients ridgeSolution(const LeastSquares& problem, double ridge) {
  GramMatrix gram = problem.features.transpose() * problem.weights.asDiagonal() * problem.features;
  gram.diagonal().tail<QUELL_FEATURES - 1>().array() += ridge * problem.weights.sum();
  return gram.ldlt().solve(problem.features.transpose() * problem.weights.asDiagonal() * problem.colors);
}

// Root mean square difference of predictions, relative to the signal's deviation; the worst channel's.
double difference(const LeastSquares& problem, const Coefficients& a, const Coefficients& b) {
  const ColorMatrix predicted = problem.features * (a - b);
  const Eigen::RowVector3d mean = problem.colors.colwise().mean();
  const ColorMatrix signal = problem.colors.rowwise() - mean;
  return (predicted.colwise().norm().array() / signal.colwise().norm().array()).maxCoeff();
}

}  // namespace

TEST_CASE("the mean Gram matrix over noise seeds is the noise-free one plus the ridge") {
  const LeastSquares problem = makeExample("independent features", 1).problem;
  REQUIRE(problem.features.rows() == kBlockPixels);
  const auto weights = problem.weights.asDiagonal();
  MatrixMean grams, noiseGrams;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const FeatureMatrix noise = noiseMatrix(seed);
    const FeatureMatrix noisy = problem.features + noise;
    grams.add(noisy.transpose() * weights * noisy);
    noiseGrams.add(noise.transpose() * weights * noise);
  }
  GramMatrix ridge = GramMatrix::Zero();
  ridge.diagonal().tail<QUELL_FEATURES - 1>().fill(kVariance * problem.weights.sum());
  CHECK(grams.deviation(problem.features.transpose() * weights * problem.features + ridge) < kStandardErrors);
  // Without the features, whose products with the noise only vanish slowly, the ridge shows to three digits.
  CHECK(noiseGrams.deviation(ridge) < kStandardErrors);
  CHECK(noiseGrams.largestStandardError() < 2e-3 * kVariance * problem.weights.sum());
}

TEST_CASE("gram_solve adds exactly the expected ridge") {
  for (const char* family : {"independent features", "planes, axis-aligned", "cut by an edge, sky"}) {
    const Example example = makeExample(family, 1);
    const Coefficients gram = coefficientsOf(example.gram);
    const double exact = difference(example.problem, gram, ridgeSolution(example.problem, kVariance));
    const double larger = difference(example.problem, gram, ridgeSolution(example.problem, 1.1 * kVariance));
    const double none = difference(example.problem, gram, ridgeSolution(example.problem, 1e-3 * kVariance));
    INFO(family << ": " << exact << ", with a ridge 10 % higher " << larger << ", with next to none "
                << none);
    CHECK(exact < 1e-5);
    CHECK(exact < 0.2 * larger);
    CHECK(exact < 0.02 * none);
  }
}

TEST_CASE("the mean of householder over noise seeds is close to gram") {
  for (const char* family : {"independent features", "constant normals", "planes, axis-aligned",
                             "planes, oblique", "features duplicated", "cut by an edge, sky"}) {
    const Example example = makeExample(family, kSeeds);
    Coefficients mean = Coefficients::Zero();
    for (const BlockFit& fit : example.householder) mean += coefficientsOf(fit) / kSeeds;
    const double ofMean = difference(example.problem, mean, coefficientsOf(example.gram));
    const double ofOne =
        difference(example.problem, coefficientsOf(example.householder[0]), coefficientsOf(example.gram));
    INFO(family << ": mean over seeds " << ofMean << " from gram, one seed " << ofOne
                << " (RMS, per deviation of the signal)");
    CHECK(ofMean < kMostMeanDifference);
    CHECK(ofMean < kMostShareOfOne * ofOne);
  }
}

}  // namespace quell::stress

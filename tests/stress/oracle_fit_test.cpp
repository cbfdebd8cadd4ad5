// The oracle itself: it must find what can be known without it, and the comparison must see a bad fit.
#include <catch2/catch.hpp>
#include <limits>

#include "tests/stress/test_fitter.hpp"

namespace quell::stress {
namespace {

struct Example {
  BlockInputs inputs;
  BlockFit fit;  // gram's
};

Example makeExample(const std::string& family) {
  const Batch batch = makeBatch(findFamily(family), 5, 0, 1);
  const BatchFit fits = sharedFitter().fit(batch, 1);
  return {fits.inputs[0], fits.gram[0]};
}

}  // namespace

TEST_CASE("the oracle finds coefficients that explain the colors exactly") {
  const Example example = makeExample("independent features");
  LeastSquares problem = makeLeastSquares(example.inputs, example.fit);
  Random random(1);
  const Coefficients wanted = Coefficients::NullaryExpr([&] { return random.uniform(-1.0, 1.0); });
  problem.colors = problem.features * wanted;
  const OptimalFit fit = solveOptimally(problem);
  CHECK((fit.coefficients - wanted).cwiseAbs().maxCoeff() < 1e-9);
  CHECK(fit.residualEnergy.maxCoeff() < 1e-15);
  CHECK(fit.condition < 1000.0);
}

TEST_CASE("the oracle's residual is orthogonal to the features") {
  for (const char* family : {"independent features", "planes, axis-aligned", "features duplicated"}) {
    const Example example = makeExample(family);
    const LeastSquares problem = makeLeastSquares(example.inputs, example.fit);
    const ColorMatrix residual = problem.colors - problem.features * solveOptimally(problem).coefficients;
    const double energy = problem.colors.squaredNorm();
    INFO(family);
    CHECK((problem.features.transpose() * problem.weights.asDiagonal() * residual).cwiseAbs().maxCoeff() <
          1e-4 * std::sqrt(energy));
  }
}

TEST_CASE("a spoilt fit shows in every figure") {
  Example example = makeExample("independent features");
  const FitErrors before = compareFit(example.inputs, example.fit);
  for (int c = 0; c < QUELL_FIT_CHANNELS; ++c)
    example.fit.record[static_cast<std::size_t>(4 * QUELL_FIT_CHANNELS + c)] += 1e6f;
  const FitErrors after = compareFit(example.inputs, example.fit);
  CHECK(after.excessResidual > before.excessResidual + 1.0);
  CHECK(after.prediction > before.prediction + 1.0);
  CHECK(after.outsideRange > before.outsideRange + 1.0);
  example.fit.record[0] = std::numeric_limits<float>::quiet_NaN();
  CHECK_FALSE(compareFit(example.inputs, example.fit).finite);
}

}  // namespace quell::stress

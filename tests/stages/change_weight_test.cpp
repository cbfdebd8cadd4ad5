#include <algorithm>
#include <cmath>

#include "tests/cases/change_weight_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

constexpr double kFullTile = double(QUELL_CHANGE_TILE) * QUELL_CHANGE_TILE;
// Of noise alone: a difference of 1.7 standard deviations makes a weight of 0.2; 8 % of a normal distribution are
// beyond it, and two windows are looked at (0.126 and a mean of 0.060 measured).
constexpr double kNoticedShare = 0.15;
constexpr double kMeanNoiseWeight = 0.075;

CaseMaker maker(int signals) {
  return
      [signals](const CaseOptions& options) { return std::make_unique<ChangeWeightCase>(options, signals); };
}

void setTiles(ChangeWeightCase& change, double count, double mean, double spread) {
  for (int tile = 0; tile < change.tileCount(); ++tile) change.setTile(tile, count, mean, spread);
}

Planes runWeights(ChangeWeightCase& change) {
  change.upload();
  change.run();
  return change.weights();
}

// Differences of differently many samples of a skewed distribution with mean 0: what a path tracer's noise is like.
Planes skewedNoise(Size size, unsigned seed) {
  Random random(seed);
  Planes noise(size, 1);
  for (float& value : noise.values) value = float(-std::log(1.0 - 0.999999 * random.uniform()) - 1.0);
  return noise;
}

}  // namespace

TEST_CASE("change_weight agrees with its oracle") { checkLayouts(maker(1), {packed(3)}); }

TEST_CASE("change_weight of two signals agrees with its oracle") { checkSizes(maker(2)); }

TEST_CASE("change_weight does not depend on the work-group") { checkWorkGroups(maker(2), {"changeWeights"}); }

TEST_CASE("change_weight of two signals equals two runs of one") {
  CaseOptions options;
  options.size = {61, 40};
  ChangeWeightCase both(options, 2);
  const std::vector<float> expected = runWeights(both).values;
  std::vector<float> found;
  for (const std::ptrdiff_t signal : {0, 1}) {
    ChangeWeightCase one(options);
    auto& sums = one.inputs.sums.values;
    const auto half = std::ptrdiff_t(sums.size());
    std::copy_n(both.inputs.sums.values.begin() + signal * half, half, sums.begin());
    const Planes weights = runWeights(one);
    found.insert(found.end(), weights.values.begin(), weights.values.end());
  }
  CHECK(found == expected);
}

TEST_CASE("change_weight is 0 where light does not differ") {
  CaseOptions options;
  options.size = {61, 40};
  ChangeWeightCase change(options);
  for (const double spread : {0.0, 1e-6, 1.0, 65504.0 * 65504.0}) {
    setTiles(change, kFullTile, 0.0, spread);
    for (const float weight : runWeights(change).values) CHECK(weight == 0.0f);
  }
}

TEST_CASE("change_weight is nearly the largest weight where light differs by far more than its noise") {
  CaseOptions options;
  options.size = {61, 40};
  ChangeWeightCase change(options);
  for (const double mean : {-1.0, 1.0, 65504.0}) {
    for (const double deviation : {0.0, 0.1}) {
      setTiles(change, kFullTile, mean, std::pow(mean * deviation, 2.0));
      for (const float weight : runWeights(change).values) {
        CHECK(weight > 0.99 * kChangeMostWeight);
        CHECK(weight <= float(kChangeMostWeight));
      }
    }
  }
}

TEST_CASE("change_weight is the same for light of any brightness") {
  CaseOptions options;
  options.size = {121, 70};
  ChangeWeightCase change(options);
  const Planes expected = runWeights(change);
  CHECK(*std::max_element(expected.values.begin(), expected.values.end()) > 0.5f);
  const Planes sums = change.inputs.sums;
  for (const float scale : {1.0f / 1024.0f, 1024.0f}) {
    for (std::size_t i = 0; i < sums.values.size(); i += QUELL_CHANGE_RECORD) {
      change.inputs.sums.values[i + QUELL_CHANGE_SUM] = scale * sums.values[i + QUELL_CHANGE_SUM];
      change.inputs.sums.values[i + QUELL_CHANGE_SQUARES] =
          scale * scale * sums.values[i + QUELL_CHANGE_SQUARES];
    }
    CHECK(sameBits(expected, runWeights(change)));
  }
}

TEST_CASE("change_weight says nothing where too few pixels were compared") {
  CaseOptions options;
  options.size = {61, 40};
  ChangeWeightCase change(options);
  const double least = QUELL_CHANGE_LEAST_SHARE * kFullTile;
  for (const double count : {0.0, least - 1.0, least}) {
    setTiles(change, count, 10.0, 0.01);
    for (const float weight : runWeights(change).values) CHECK((weight > 0.5f) == (count == least));
  }
}

TEST_CASE("change_weight takes noise alone for change in few tiles") {
  CaseOptions options;
  options.size = {1280, 720};
  ChangeWeightCase change(options, 1, ChangeSettings::Defaults);
  ChangeSumsInputs noise;
  noise.innovation = skewedNoise(options.size, 17);
  noise.historyLength = Planes(options.size, 1, 8.0f);
  noise.sumsPrev = Planes(change.inputs.sums.size(), 1);
  const ExactPlanes sums = changeSumsOracle(noise).sums;
  std::transform(sums.values.begin(), sums.values.end(), change.inputs.sums.values.begin(),
                 [](double value) { return float(value); });
  const Planes weights = runWeights(change);
  double noticed = 0.0, sum = 0.0;
  for (const float weight : weights.values) {
    noticed += weight > 0.2f;
    sum += weight;
  }
  const double tiles = double(weights.values.size());
  INFO(noticed / tiles << " of the tiles above 0.2, mean weight " << sum / tiles);
  CHECK(noticed > 0.0);
  CHECK(noticed < kNoticedShare * tiles);
  CHECK(sum < kMeanNoiseWeight * tiles);
}

TEST_CASE("change_weight is a weight for the most extreme sums") {
  CaseOptions options;
  options.size = {257, 89};
  ChangeWeightCase change(options);
  Random random(3);
  const double means[] = {0.0, 1e-45, -1e-38, 1e-20, 65504.0, -65504.0};
  const double counts[] = {0.0, 1.0, kFullTile, 100.0 * kFullTile};
  for (int tile = 0; tile < change.tileCount(); ++tile) {
    const double mean = means[random.integer(0, int(std::size(means)) - 1)];
    change.setTile(tile, counts[random.integer(0, int(std::size(counts)) - 1)], mean,
                   random.uniform() < 0.5 ? 0.0 : mean * mean);
  }
  for (const float weight : runWeights(change).values)
    CHECK((weight >= 0.0f && weight <= float(kChangeMostWeight)));
}

#include <algorithm>
#include <cmath>

#include "tests/cases/change_weight_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

constexpr double kFullTile = double(QUELL_TILE) * QUELL_TILE;
// Of noise alone, after this many frames; 0.006 of the tiles above a weight of 0.2 and a mean of 0.003 measured.
constexpr int kNoiseFrames = 24;
constexpr double kNoticedShare = 0.02;
constexpr double kMeanNoiseWeight = 0.01;

CaseMaker maker(int signals) {
  return
      [signals](const CaseOptions& options) { return std::make_unique<ChangeWeightCase>(options, signals); };
}

// Everywhere the same; without a past.
void setTiles(ChangeWeightCase& change, double count, double mean, double spread) {
  std::fill(change.inputs.recentChangePrev.values.begin(), change.inputs.recentChangePrev.values.end(), 0.0f);
  for (int tile = 0; tile < change.tileCount(); ++tile)
    change.setTile(tile, count, {mean, spread}, {0.0, 0.0});
}

Planes runWeights(ChangeWeightCase& change) {
  change.uploadAndRun();
  return change.weights();
}

// Differences of differently many samples of a skewed distribution with mean 0: what a path tracer's noise is like.
// Luminance and chrominance share half of their deviation: samples are bright or dark, and coloured.
Planes skewedNoise(Size size, unsigned seed) {
  Random random(seed);
  const auto skewed = [&] { return -std::log(1.0 - 0.999999 * random.uniform()) - 1.0; };
  Planes noise(size, QUELL_INNOVATION_PLANES);
  forEachPixel(size, [&](int x, int y) {
    const double luminance = skewed();
    noise.at(QUELL_INNOVATION_LUMINANCE, x, y) = float(luminance);
    noise.at(QUELL_INNOVATION_CHROMINANCE, x, y) = float(0.1 * (luminance + skewed()));
  });
  return noise;
}

}  // namespace

TEST_CASE("change_weight agrees with its oracle") { checkLayouts(maker(1), {packed(3)}); }

TEST_CASE("change_weight of two signals agrees with its oracle") { checkSizes(maker(2)); }

TEST_CASE("change_weight does not depend on the work-group") {
  checkWorkGroups(maker(2), {"changeWeights", "recentChange"});
}

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
    auto& recentChange = one.inputs.recentChangePrev.values;
    const auto tiles = std::ptrdiff_t(recentChange.size());
    std::copy_n(both.inputs.recentChangePrev.values.begin() + signal * tiles, tiles, recentChange.begin());
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

TEST_CASE("change_weight sees light that changes its colour alone, and no colour in grey light") {
  CaseOptions options;
  options.size = {61, 40};
  ChangeWeightCase change(options);
  setTiles(change, kFullTile, 0.0, 1.0);
  for (int tile = 0; tile < change.tileCount(); ++tile)
    change.setTile(tile, kFullTile, {0.0, 1.0}, {0.5, 0.01});
  for (const float weight : runWeights(change).values) CHECK(weight > 0.9 * kChangeMostWeight);
  // Rounding errors of one sign, in light a million times as bright.
  for (int tile = 0; tile < change.tileCount(); ++tile)
    change.setTile(tile, kFullTile, {0.0, 1.0}, {1e-6, 1e-14});
  for (const float weight : runWeights(change).values) CHECK(weight == 0.0f);
}

TEST_CASE("change_weight believes in what neighbours agree on, though it cancels out") {
  CaseOptions options;
  options.size = {61, 40};
  ChangeWeightCase change(options);
  setTiles(change, kFullTile, 0.0, 2.0);
  const int tile = 9;
  change.inputs.sums.values[tile * QUELL_CHANGE_RECORD + QUELL_CHANGE_AGREEMENT] = 500.0f;
  const Planes weights = runWeights(change);
  for (int i = 0; i < change.tileCount(); ++i)
    CHECK((weights.at(0, i, 0) > 0.9 * kChangeMostWeight) == (i == tile));
}

TEST_CASE("change_weight is the same for light of any brightness") {
  CaseOptions options;
  options.size = {121, 70};
  ChangeWeightCase change(options);
  const Planes expected = runWeights(change);
  CHECK(*std::max_element(expected.values.begin(), expected.values.end()) > 0.5f);
  const Planes sums = change.inputs.sums;
  // From a ten-millionth of the usual light to a thousandfold.
  for (const float scale : {1.0f / float(1 << 23), 1.0f / 1024.0f, 1024.0f}) {
    for (std::size_t i = 0; i < sums.values.size(); i += QUELL_CHANGE_RECORD) {
      for (std::size_t plane = 0; plane < QUELL_INNOVATION_PLANES; ++plane) {
        const std::size_t sum = i + QUELL_CHANGE_SUM(plane), squares = i + QUELL_CHANGE_SQUARES(plane);
        change.inputs.sums.values[sum] = scale * sums.values[sum];
        change.inputs.sums.values[squares] = scale * scale * sums.values[squares];
      }
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

TEST_CASE("change_weight believes in less change where there was change lately") {
  CaseOptions options;
  options.size = {61, 40};
  ChangeWeightCase change(options, 1, ChangeSettings::Defaults);
  // 1.6 standard deviations of the large window's mean: its tent of weights 1, 2, 3, 2, 1 averages as much noise away
  // as (9^2 / 19)^2 whole tiles.
  const double spread = 1.0, tilesOfWindow = 6561.0 / 361.0;
  setTiles(change, kFullTile, 1.6 * std::sqrt(spread / (kFullTile * tilesOfWindow)), spread);
  for (const float weight : runWeights(change).values) CHECK(weight < 0.5f);
  const Planes still = change.weights();
  std::fill(change.inputs.recentChangePrev.values.begin(), change.inputs.recentChangePrev.values.end(), 4.0f);
  const Planes changing = runWeights(change);
  const int inner = 2 * TileGrid(options.size).columns + 3;
  CHECK(still.at(0, inner, 0) == 0.0f);
  CHECK(changing.at(0, inner, 0) > 0.2f);
}

TEST_CASE("change_weight remembers change around a tile, and forgets it") {
  CaseOptions options;
  options.size = {121, 70};
  ChangeWeightCase change(options);
  setTiles(change, kFullTile, 0.0, 1.0);
  const TileGrid grid(options.size);
  const auto at = [&](const Planes& planes, int column, int row) {
    return planes.at(0, row * grid.columns + column, 0);
  };
  change.inputs.recentChangePrev.at(0, 4 * grid.columns + 6, 0) = QUELL_RECENT_CHANGE_MOST;
  runWeights(change);
  Planes recentChange = change.recentChange();
  CHECK(at(recentChange, 6, 4) == Approx(QUELL_RECENT_CHANGE_KEPT * QUELL_RECENT_CHANGE_MOST / 4.0f));
  CHECK(at(recentChange, 7, 4) == Approx(QUELL_RECENT_CHANGE_KEPT * QUELL_RECENT_CHANGE_MOST / 8.0f));
  CHECK(at(recentChange, 7, 5) == Approx(QUELL_RECENT_CHANGE_KEPT * QUELL_RECENT_CHANGE_MOST / 16.0f));
  CHECK(at(recentChange, 8, 4) == 0.0f);
  // The same everywhere, borders included, keeps its level but for what is forgotten.
  std::fill(change.inputs.recentChangePrev.values.begin(), change.inputs.recentChangePrev.values.end(), 2.0f);
  runWeights(change);
  recentChange = change.recentChange();
  for (const float value : recentChange.values) CHECK(value == Approx(QUELL_RECENT_CHANGE_KEPT * 2.0f));
  // A restarted history has no recent change, whatever the buffer holds.
  change.useFrame(0);
  std::fill(change.inputs.recentChangePrev.values.begin(), change.inputs.recentChangePrev.values.end(), NAN);
  runWeights(change);
  recentChange = change.recentChange();
  for (const float value : recentChange.values) CHECK(value == 0.0f);
}

TEST_CASE("change_weight takes noise alone for change in few tiles") {
  CaseOptions options;
  options.size = {640, 360};
  ChangeWeightCase change(options, 1, ChangeSettings::Defaults);
  ChangeSumsInputs noise;
  noise.historyLength = Planes(options.size, 1, 8.0f);
  noise.sumsPrev = Planes(change.inputs.sums.size(), 1);
  noise.sumsKept = Settings("quell").get("changeMemory");
  std::fill(change.inputs.recentChangePrev.values.begin(), change.inputs.recentChangePrev.values.end(), 0.0f);
  Planes weights;
  for (unsigned frame = 0; frame < kNoiseFrames; ++frame) {
    noise.innovation = skewedNoise(options.size, 17 + frame);
    const ExactPlanes sums = changeSumsOracle(noise).sums;
    std::transform(sums.values.begin(), sums.values.end(), change.inputs.sums.values.begin(),
                   [](double value) { return float(value); });
    weights = runWeights(change);
    noise.sumsPrev = change.inputs.sums;
    change.inputs.recentChangePrev = change.recentChange();
  }
  double noticed = 0.0, sum = 0.0;
  for (const float weight : weights.values) {
    noticed += weight > 0.2f;
    sum += weight;
  }
  double recentChange = 0.0;
  for (const float value : change.inputs.recentChangePrev.values) recentChange += value;
  const double tiles = double(weights.values.size());
  INFO(noticed / tiles << " of the tiles above 0.2, mean weight " << sum / tiles << ", mean recentChange "
                       << recentChange / tiles);
  CHECK(noticed > 0.0);
  CHECK(noticed < kNoticedShare * tiles);
  CHECK(sum < kMeanNoiseWeight * tiles);
  CHECK(recentChange < double(QUELL_RECENT_CHANGE_NONE) * tiles);
}

TEST_CASE("change_weight is a weight for the most extreme sums") {
  CaseOptions options;
  options.size = {257, 89};
  ChangeWeightCase change(options);
  Random random(3);
  constexpr double mostIrradiance = 65504.0 / 0.01;
  const double means[] = {0.0, 1e-45, -1e-38, 1e-20, mostIrradiance, -mostIrradiance};
  const double counts[] = {0.0, 1.0, kFullTile, 100.0 * kFullTile};
  for (int tile = 0; tile < change.tileCount(); ++tile) {
    const double mean = means[random.integer(0, int(std::size(means)) - 1)];
    const auto differences = [&] {
      return ChangeWeightCase::Differences{mean, random.uniform() < 0.5 ? 0.0 : mean * mean};
    };
    const ChangeWeightCase::Differences luminance = differences();
    change.setTile(tile, counts[random.integer(0, int(std::size(counts)) - 1)], luminance, differences());
  }
  for (const float weight : runWeights(change).values)
    CHECK((weight >= 0.0f && weight <= float(kChangeMostWeight)));
}

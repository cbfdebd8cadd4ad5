#include <cmath>

#include "tests/cases/light_gain_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(int signals) {
  return [signals](const CaseOptions& options) { return std::make_unique<LightGainCase>(options, signals); };
}

Planes runGains(LightGainCase& gain) {
  gain.uploadAndRun();
  return gain.gains();
}

// Everywhere the same.
void setTiles(LightGainCase& gain, double lost, double squares) {
  for (int tile = 0; tile < gain.tileCount(); ++tile) gain.setTile(tile, lost, squares);
}

}  // namespace

TEST_CASE("light_gain agrees with its oracle") { checkLayouts(maker(1), {packed(3)}); }

TEST_CASE("light_gain of two signals agrees with its oracle") { checkSizes(maker(2)); }

TEST_CASE("light_gain does not depend on the work-group nor on the number of lanes") {
  checkWorkGroups(maker(2), {"lightGain"});
}

TEST_CASE("light_gain gives back what even light has lost, and takes what it has won") {
  CaseOptions options;
  options.size = {480, 270};
  LightGainCase gain(options);
  const TileGrid grid(options.size);
  const double pixels = 32.0, luminance = 2.0;
  for (const double lostShare : {0.1, -0.1}) {
    setTiles(gain, pixels * lostShare * luminance, pixels * luminance * luminance);
    const Planes gains = runGains(gain);
    for (const float value : gains.values) {
      // Nearly all, at the corners a little less: the fewer tiles, the less is sure.
      const double share = (lightRatio(value, luminance) - 1.0) / lostShare;
      CHECK(share > 0.9);
      CHECK(share < 1.0);
    }
    const double inside = gains.at(0, grid.rows / 2 * grid.columns + grid.columns / 2, 0);
    CHECK(lightRatio(inside, luminance) == Approx(1.0 + lostShare).margin(0.003));
  }
}

TEST_CASE("light_gain is 0 where one tile holds all that was lost") {
  CaseOptions options;
  options.size = {257, 89};
  LightGainCase gain(options);
  setTiles(gain, 0.0, 32.0);
  gain.setTile(5 * TileGrid(options.size).columns + 9, 1000.0, 50.0);
  for (const float value : runGains(gain).values) CHECK(value == 0.0f);
}

TEST_CASE("light_gain is 0 without light") {
  LightGainCase gain({});
  setTiles(gain, 0.0, 0.0);
  for (const float value : runGains(gain).values) CHECK(value == 0.0f);
  setTiles(gain, 5.0, 0.0);
  for (const float value : runGains(gain).values) CHECK(value == 0.0f);
}

TEST_CASE("light_gain of the most extreme sums times any luminance is finite") {
  CaseOptions options;
  options.size = {257, 89};
  LightGainCase gain(options);
  Random random(3);
  const double luminances[] = {0.0, 1e-45, 1e-30, 1e-18, 65504.0};
  const auto any = [&] { return luminances[random.integer(0, int(std::size(luminances)) - 1)]; };
  for (int tile = 0; tile < gain.tileCount(); ++tile) {
    const double luminance = any();
    gain.setTile(tile, 32.0 * (any() - luminance), 32.0 * luminance * luminance);
  }
  for (const float value : runGains(gain).values) CHECK(std::isfinite(value * 65504.0f));
  setTiles(gain, 32.0 * 65504.0, 1e-45);
  for (const float value : runGains(gain).values) CHECK(std::isfinite(value * 65504.0f));
}

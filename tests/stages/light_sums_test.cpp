#include "kernels/common/guides.h"
#include "tests/cases/light_sums_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

// The brightest light, next to nothing, and none.
constexpr float kExtremes[] = {0.0f, 1e-45f, 1e-38f, 1e-20f, 65504.0f};

CaseMaker maker(int signals) {
  return [signals](const CaseOptions& options) { return std::make_unique<LightSumsCase>(options, signals); };
}

Planes runSums(LightSumsCase& sums) {
  sums.uploadAndRun();
  return sums.sums();
}

}  // namespace

TEST_CASE("light_sums agrees with its oracle") { checkLayouts(maker(1), {packed(3)}); }

TEST_CASE("light_sums of two signals agrees with its oracle") { checkSizes(maker(2)); }

TEST_CASE("light_sums does not depend on the work-group nor on the number of lanes") {
  checkWorkGroups(maker(2), {"lightSums"});
}

TEST_CASE("light_sums leave out pixels without a sample, and background, whatever those hold") {
  CaseOptions options;
  options.size = {77, 43};
  options.skip = Skip::On;
  LightSumsCase sums(options, 2);
  const Planes expected = runSums(sums);
  for (int signal = 0; signal < 2; ++signal) {
    forEachPixel(options.size, [&](int x, int y) {
      if (sums.inputs.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y) > 0.0f) return;
      sums.inputs.stopLuminance.at(signal, x, y) = 65504.0f;
      for (int c = 0; c < 3; ++c) sums.inputs.filtered.at(3 * signal + c, x, y) = 65504.0f;
    });
  }
  CHECK(sameBits(expected, runSums(sums)));
}

TEST_CASE("light_sums of constant light are its multiples") {
  CaseOptions options;
  options.size = {20, 11};  // the last tiles are 4 pixels wide and 3 high, of which two rows count
  LightSumsCase sums(options);
  fill(sums.inputs.stopLuminance, 3.0f);
  fill(sums.inputs.filtered, 2.0f);
  fill(sums.inputs.guides, 1.0f);
  const Planes result = runSums(sums);
  const double pixels[] = {32.0, 32.0, 16.0, 16.0, 16.0, 8.0};
  REQUIRE(result.values.size() == std::size(pixels) * QUELL_LIGHT_RECORD);
  for (std::size_t tile = 0; tile < std::size(pixels); ++tile) {
    CHECK(result.values[tile * QUELL_LIGHT_RECORD + QUELL_LIGHT_LOST] == Approx(pixels[tile]).epsilon(1e-6));
    CHECK(result.values[tile * QUELL_LIGHT_RECORD + QUELL_LIGHT_SQUARES] ==
          Approx(4.0 * pixels[tile]).epsilon(1e-6));
  }
}

TEST_CASE("light_sums count at most twice the light that is left as lost") {
  CaseOptions options;
  LightSumsCase sums(options);
  fill(sums.inputs.stopLuminance, 50.0f);
  fill(sums.inputs.filtered, 2.0f);
  fill(sums.inputs.guides, 1.0f);
  CHECK(runSums(sums).values[QUELL_LIGHT_LOST] == Approx(2.0 * 32.0 * 2.0).epsilon(1e-6));
}

TEST_CASE("light_sums of the most extreme light are finite") {
  CaseOptions options;
  options.size = {61, 40};
  LightSumsCase sums(options);
  Random random(5);
  for (Planes* planes : {&sums.inputs.stopLuminance, &sums.inputs.filtered})
    for (float& value : planes->values) value = kExtremes[random.integer(0, int(std::size(kExtremes)) - 1)];
  CHECK(allFinite(runSums(sums)));
}

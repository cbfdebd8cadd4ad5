#include <algorithm>
#include <cmath>

#include "tests/cases/change_sums_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

// The brightest difference, next to nothing, and none.
constexpr float kExtremes[] = {0.0f, 1e-45f, -1e-38f, 65504.0f, -65504.0f};

CaseMaker maker(int signals) {
  return [signals](const CaseOptions& options) { return std::make_unique<ChangeSumsCase>(options, signals); };
}

Planes runSums(ChangeSumsCase& sums) {
  sums.uploadAndRun();
  return sums.sums();
}

}  // namespace

TEST_CASE("change_sums agrees with its oracle") { checkLayouts(maker(1), {packed(3)}); }

TEST_CASE("change_sums of two signals agrees with its oracle") { checkSizes(maker(2)); }

TEST_CASE("change_sums does not depend on the work-group") { checkWorkGroups(maker(2), {"changeSums"}); }

TEST_CASE("change_sums of a constant difference are its multiples") {
  CaseOptions options;
  options.size = {20, 11};  // the last tiles are 4 pixels wide and 3 high
  ChangeSumsCase sums(options);
  for (int y = 0; y < options.size.height; ++y) {
    for (int x = 0; x < options.size.width; ++x) {
      sums.inputs.innovation.at(QUELL_INNOVATION_LUMINANCE, x, y) = -0.5f;
      sums.inputs.innovation.at(QUELL_INNOVATION_CHROMINANCE, x, y) = 2.0f;
    }
  }
  fill(sums.inputs.historyLength, 2.0f);
  fill(sums.inputs.sumsPrev, 0.0f);
  const Planes result = runSums(sums);
  const float pixels[] = {64.0f, 64.0f, 32.0f, 24.0f, 24.0f, 12.0f};
  REQUIRE(result.values.size() == std::size(pixels) * QUELL_CHANGE_RECORD);
  for (int tile = 0; tile < int(std::size(pixels)); ++tile) {
    const float* record = &result.values[std::size_t(tile) * QUELL_CHANGE_RECORD];
    CHECK(record[QUELL_CHANGE_COUNT] == pixels[tile]);
    CHECK(record[QUELL_CHANGE_SUM(QUELL_INNOVATION_LUMINANCE)] == -0.5f * pixels[tile]);
    CHECK(record[QUELL_CHANGE_SQUARES(QUELL_INNOVATION_LUMINANCE)] == 0.25f * pixels[tile]);
    CHECK(record[QUELL_CHANGE_SUM(QUELL_INNOVATION_CHROMINANCE)] == 2.0f * pixels[tile]);
    CHECK(record[QUELL_CHANGE_SQUARES(QUELL_INNOVATION_CHROMINANCE)] == 4.0f * pixels[tile]);
  }
}

TEST_CASE("change_sums leave out pixels without history, whatever those hold") {
  CaseOptions options;
  ChangeSumsCase sums(options, 2);
  const Planes expected = runSums(sums);
  for (int plane = 0; plane < sums.inputs.innovation.count; ++plane) {
    forEachPixel(options.size, [&](int x, int y) {
      const float length = sums.inputs.historyLength.at(plane / QUELL_INNOVATION_PLANES, x, y);
      if (length <= 1.0f) sums.inputs.innovation.at(plane, x, y) = 65504.0f;
    });
  }
  CHECK(sameBits(expected, runSums(sums)));
}

TEST_CASE("change_sums keep a share of the frame before, and nothing after a reset") {
  CaseOptions options;
  ChangeSumsCase sums(options);
  fill(sums.inputs.historyLength, 0.0f);
  const Planes kept = runSums(sums);
  for (std::size_t i = 0; i < kept.values.size(); ++i) {
    // Agreement is that of this frame alone, and no pixel was compared.
    const double memory = i % QUELL_CHANGE_RECORD == QUELL_CHANGE_AGREEMENT ? 0.0 : kChangeMemory;
    CHECK(kept.values[i] == Approx(memory * sums.inputs.sumsPrev.values[i]).epsilon(1e-6));
  }
  sums.useFrame(0);
  for (const float value : runSums(sums).values) CHECK(value == 0.0f);
}

TEST_CASE("change_sums tell stripes that move from noise") {
  CaseOptions options;
  options.size = {48, 24};
  ChangeSumsCase sums(options);
  fill(sums.inputs.historyLength, 8.0f);
  Random random(11);
  const auto agreements = [&](const auto& differenceAt) {
    forEachPixel(options.size, [&](int x, int y) {
      sums.inputs.innovation.at(QUELL_INNOVATION_LUMINANCE, x, y) = float(differenceAt(x));
    });
    const Planes result = runSums(sums);
    std::vector<float> found;
    for (std::size_t i = 0; i < result.values.size(); i += QUELL_CHANGE_RECORD)
      found.push_back(result.values[i + QUELL_CHANGE_AGREEMENT]);
    return found;
  };
  // Their mean is 0: no window sees them.
  for (const float odds : agreements([](int x) { return x / 4 % 2 ? 1.5 : -1.5; })) CHECK(odds > 100.0f);
  // A fifth of what changes is noise.
  for (const float odds :
       agreements([&](int x) { return (x / 4 % 2 ? 1.5 : -1.5) + random.uniform(-0.15, 0.15); }))
    CHECK(odds > 1.0f);
  for (const float odds : agreements([&](int) { return random.uniform(-1.5, 1.5); })) CHECK(odds < 0.5f);
  // All samples of a dim light missed it, and their histories hold from none to a few of its samples.
  for (const float odds : agreements([&](int) { return -double(random.integer(0, 4)); })) CHECK(odds < 0.9f);
  for (const float odds : agreements([](int) { return 0.0; })) CHECK(odds == 0.0f);
}

TEST_CASE("change_sums of the most extreme differences are finite") {
  CaseOptions options;
  options.size = {61, 40};
  ChangeSumsCase sums(options);
  Random random(5);
  for (float& value : sums.inputs.innovation.values)
    value = kExtremes[random.integer(0, int(std::size(kExtremes)) - 1)];
  checkAgreement(sums, options);
  CHECK(allFinite(sums.sums()));
}

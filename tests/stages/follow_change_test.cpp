#include <algorithm>
#include <cmath>

#include "tests/cases/follow_change_case.hpp"
#include "tests/oracle/edge_stops_oracle.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(int signals) {
  return
      [signals](const CaseOptions& options) { return std::make_unique<FollowChangeCase>(options, signals); };
}

FollowChangeOutputs runFollow(FollowChangeCase& follow) {
  follow.uploadAndRun();
  return follow.outputs();
}

void checkUntouched(const FollowChangeCase& follow, const FollowChangeOutputs& outputs) {
  CHECK(sameBits(outputs.irradiance, follow.inputs.irradiance));
  CHECK(sameBits(outputs.moments, follow.inputs.moments));
  CHECK(sameBits(outputs.historyLength, follow.inputs.historyLength));
}

}  // namespace

TEST_CASE("follow_change agrees with its oracle") { checkLayouts(maker(1), {packed(3)}); }

TEST_CASE("follow_change of two signals agrees with its oracle") { checkSizes(maker(2)); }

TEST_CASE("follow_change leaves out background") { checkHoles(maker(2)); }

TEST_CASE("follow_change does not depend on the work-group nor on the number of lanes") {
  checkWorkGroups(maker(2), {"irradiance", "moments", "historyLength"});
}

TEST_CASE("follow_change touches nothing where the newest sample has its weight already") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const float weight : {0.0f, float(kChangeLeastWeight)}) {
      CaseOptions options;
      options.size = {61, 40};
      options.mapping = mapping;
      FollowChangeCase follow(options, 2);
      fill(follow.inputs.weights, weight);
      checkUntouched(follow, runFollow(follow));
    }
    CaseOptions options;
    options.mapping = mapping;
    FollowChangeCase first(options);
    fill(first.inputs.weights, 1.0f);
    fill(first.inputs.historyLength, 1.0f);
    checkUntouched(first, runFollow(first));
  }
}

TEST_CASE("follow_change next to a change touches nothing that the change does not reach") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    FollowChangeCase follow(options);
    const FollowChangeExact exact = followChangeOracle(follow.inputs);
    const FollowChangeOutputs outputs = runFollow(follow);
    const auto touched = std::count(exact.touched.values.begin(), exact.touched.values.end(), char(1));
    CHECK(touched > 500);
    CHECK(touched < 2000);
    BasicPlanes<char> mayDiffer = exact.touched;
    for (std::size_t i = 0; i < mayDiffer.values.size(); ++i)
      mayDiffer.values[i] |= exact.undecided.values[i];
    CHECK(sameBits(outputs.irradiance, follow.inputs.irradiance, &mayDiffer));
    CHECK(sameBits(outputs.moments, follow.inputs.moments, &mayDiffer));
    CHECK(sameBits(outputs.historyLength, follow.inputs.historyLength, &mayDiffer));
  }
}

TEST_CASE("follow_change with all weight on the newest sample gives it, and forgets the history") {
  for (const CaseOptions& options : bothMappings()) {
    FollowChangeCase follow(options);
    fill(follow.inputs.weights, 1.0f);
    fill(follow.inputs.historyLength, 7.0f);
    const FollowChangeOutputs outputs = runFollow(follow);
    const Planes& newest = follow.inputs.newestIrradiance;
    forEachPixel(options.size, [&](int x, int y) {
      for (int c = 0; c < 3; ++c)
        CHECK(outputs.irradiance.at(c, x, y) == Approx(newest.at(c, x, y)).margin(1e-5));
      const double luminance = luminanceOf(newest.at(0, x, y), newest.at(1, x, y), newest.at(2, x, y));
      CHECK(outputs.moments.at(QUELL_MOMENT_FIRST, x, y) == Approx(luminance).margin(1e-5));
      CHECK(outputs.moments.at(QUELL_MOMENT_SECOND, x, y) == Approx(luminance * luminance).margin(1e-4));
      CHECK(outputs.historyLength.at(0, x, y) == 1.0f);
    });
  }
}

TEST_CASE("follow_change shortens the history to what it is worth and never lengthens it") {
  for (const CaseOptions& options : bothMappings()) {
    for (const float weight : {0.16f, 0.21f, 0.3f, 0.45f, 0.6f, 0.9f}) {
      FollowChangeCase follow(options);
      fill(follow.inputs.weights, weight);
      const FollowChangeOutputs outputs = runFollow(follow);
      const float worth = std::round(1.0f / weight);
      INFO("weight " << weight);
      forEachPixel(options.size, [&](int x, int y) {
        const float before = follow.inputs.historyLength.at(0, x, y);
        CHECK(outputs.historyLength.at(0, x, y) == std::min(before, worth));
      });
    }
  }
}

TEST_CASE("follow_change leaves the light of pixels without a newest sample alone") {
  CaseOptions options;
  FollowChangeCase follow(options);
  fill(follow.inputs.weights, 0.9f);
  follow.inputs.newestIrradiance = follow.inputs.irradiance;
  CHECK(sameBits(runFollow(follow).irradiance, follow.inputs.irradiance));
}

TEST_CASE("follow_change of the most extreme light stays between history and newest sample") {
  const float extremes[] = {0.0f, 1e-45f, 1e-38f, 1e-20f, 65504.0f};
  for (const CaseOptions& options : bothMappings({61, 40})) {
    FollowChangeCase follow(options);
    Random random(9);
    for (Planes* planes : {&follow.inputs.irradiance, &follow.inputs.newestIrradiance})
      for (float& value : planes->values) value = extremes[random.integer(0, int(std::size(extremes)) - 1)];
    for (float& value : follow.inputs.moments.values)
      value = random.uniform() < 0.5 ? 0.0f : 65504.0f * 65504.0f;
    for (float& weight : follow.inputs.weights.values) weight = float(random.integer(0, 1));
    const FollowChangeOutputs outputs = runFollow(follow);
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < outputs.irradiance.values.size(); ++i) {
      const auto [low, high] =
          std::minmax({follow.inputs.irradiance.values[i], follow.inputs.newestIrradiance.values[i]});
      const float rounding = 1e-6f * high;
      const float value = outputs.irradiance.values[i];
      beyond += !(value >= 0.0f && value >= low - rounding && value <= high + rounding);
    }
    CHECK(beyond == 0);
    for (const float moment : outputs.moments.values) CHECK((moment >= 0.0f && std::isfinite(moment)));
  }
}

TEST_CASE("follow_change leaves pixels without a sample alone") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    FollowChangeCase follow(options, 2);
    for (int plane = 0; plane < follow.inputs.newestIrradiance.count; ++plane)
      for (int y = 0; y < options.size.height; ++y)
        follow.inputs.newestIrradiance.at(plane, (7 * y) % options.size.width, y) = -1.0f;
    checkAgreement(follow, options);
  }
}

#include <algorithm>
#include <cmath>

#include "tests/cases/variance_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

constexpr float kLongHistory = 8.0f;  // trusted over time
constexpr float kShortHistory = 2.0f;
// What accumulation can leave behind at most, the square of the brightest light, and next to nothing.
constexpr float kExtremes[] = {0.0f, 1e-45f, 1e-38f, 1e-20f, 65504.0f};

CaseMaker maker(int signals) {
  return [signals](const CaseOptions& options) { return std::make_unique<VarianceCase>(options, signals); };
}

bool hasSample(const VarianceCase& variance, int x, int y) {
  return variance.inputs.guides.guides.at(QUELL_GUIDE_WEIGHT, x, y) > 0.0f;
}

Planes runVariance(VarianceCase& variance) {
  variance.uploadAndRun();
  return variance.variance();
}

}  // namespace

TEST_CASE("variance agrees with its oracle") { checkSizes(maker(1)); }

TEST_CASE("variance of two signals agrees with its oracle") { checkLayouts(maker(2), {packed(3)}); }

TEST_CASE("variance leaves out background") {
  checkHoles(maker(2));
  checkHoles([](const CaseOptions& options) {
    return std::make_unique<VarianceCase>(options, 1, VarianceOf::Mean);
  });
}

TEST_CASE("variance does not depend on the work-group") { checkWorkGroups(maker(2), {"variance"}); }

TEST_CASE("variance of two signals equals two runs of one") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    VarianceCase both(options, 2);
    const Planes expected = runVariance(both);
    for (const int signal : {0, 1}) {
      VarianceCase one(options, 1);
      one.inputs.guides = both.inputs.guides;
      one.inputs.guides.guides = guidesOfSignal(both.inputs.guides.guides, signal);
      one.inputs.moments = planesOf(both.inputs.moments, QUELL_MOMENT_PLANES * signal, QUELL_MOMENT_PLANES);
      one.inputs.historyLength = planesOf(both.inputs.historyLength, signal, 1);
      Comparison comparison;
      compareSignal(comparison, "variance", expected, signal, runVariance(one));
      INFO(comparison.worst());
      CHECK(comparison.largestError() <= 1e-6);
    }
  }
}

TEST_CASE("variance of a constant is 0 whatever the history") {
  for (const CaseOptions& options : bothMappings()) {
    VarianceCase variance(options);
    constexpr float kLuminance = 3.3f;
    fill(variance.inputs.moments, kLuminance);
    forEachPixel(options.size, [&](int x, int y) {
      variance.inputs.moments.at(QUELL_MOMENT_SECOND, x, y) = kLuminance * kLuminance;
    });
    // The rounding of a mean of 49 moments, raised by up to temporalFrames.
    for (const float value : runVariance(variance).values) CHECK(value <= 1e-5f * kLuminance * kLuminance);
  }
}

TEST_CASE("variance over a long history is the second moment minus the squared first") {
  for (const CaseOptions& options : bothMappings()) {
    VarianceCase variance(options);
    fill(variance.inputs.historyLength, kLongHistory);
    const Planes result = runVariance(variance);
    forEachPixel(options.size, [&](int x, int y) {
      const double first = variance.inputs.moments.at(QUELL_MOMENT_FIRST, x, y);
      const double second = variance.inputs.moments.at(QUELL_MOMENT_SECOND, x, y);
      CHECK(result.at(0, x, y) == Approx(std::max(second - first * first, 0.0)).margin(4e-6));
    });
  }
}

TEST_CASE("variance is raised the more the shorter the history") {
  CaseOptions options;
  VarianceCase variance(options);
  fill(variance.inputs.historyLength, 1.0f);
  const Planes once = runVariance(variance);
  for (const float length : {0.0f, 2.0f, 4.0f}) {
    fill(variance.inputs.historyLength, length);
    const Planes result = runVariance(variance);
    forEachPixel(options.size, [&](int x, int y) {
      if (!hasSample(variance, x, y)) return;
      CHECK(result.at(0, x, y) == Approx(once.at(0, x, y) / std::max(length, 1.0f)).epsilon(1e-6));
    });
  }
}

TEST_CASE("variance of background is 0 and its moments reach no surface") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    VarianceCase variance(options);
    Planes results[2];
    for (const int run : {0, 1}) {
      // What accumulation stores there, then rubbish.
      forEachPixel(options.size, [&](int x, int y) {
        if (hasSample(variance, x, y)) return;
        variance.inputs.historyLength.at(0, x, y) = 0.0f;
        variance.inputs.moments.at(QUELL_MOMENT_FIRST, x, y) = run == 0 ? 0.0f : 1e3f;
        variance.inputs.moments.at(QUELL_MOMENT_SECOND, x, y) = run == 0 ? 0.0f : 1e8f;
      });
      results[run] = runVariance(variance);
    }
    std::size_t leaks = 0, nonZero = 0;
    forEachPixel(options.size, [&](int x, int y) {
      if (hasSample(variance, x, y))
        leaks += results[0].at(0, x, y) != results[1].at(0, x, y);
      else
        nonZero += results[0].at(0, x, y) != 0.0f;
    });
    CHECK(leaks == 0);
    CHECK(nonZero == 0);
  }
}

TEST_CASE("variance is finite and not negative for the most extreme moments, depths and normals") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    VarianceCase variance(options);
    Random random(3);
    const auto extreme = [&] { return kExtremes[random.integer(0, int(std::size(kExtremes)) - 1)]; };
    forEachPixel(options.size, [&](int x, int y) {
      const float first = extreme();
      variance.inputs.moments.at(QUELL_MOMENT_FIRST, x, y) = first;
      variance.inputs.moments.at(QUELL_MOMENT_SECOND, x, y) = std::max(extreme(), first) * first;
      variance.inputs.guides.viewDepth.at(0, x, y) = random.uniform() < 0.1 ? 1e18f : extreme();
      for (int axis = 0; axis < 3; ++axis)
        variance.inputs.guides.guides.at(QUELL_GUIDE_NORMAL + axis, x, y) = float(random.uniform(-1.1, 1.1));
      variance.inputs.historyLength.at(0, x, y) = random.uniform() < 0.5 ? kShortHistory : kLongHistory;
    });
    std::size_t bad = 0;
    for (const float value : runVariance(variance).values) bad += !(value >= 0.0f && std::isfinite(value));
    CHECK(bad == 0);
  }
}

TEST_CASE("variance of the mean agrees with its oracle") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const Size size : {Size{1, 1}, Size{7, 93}, Size{33, 31}}) {
      CaseOptions options;
      options.size = size;
      options.mapping = mapping;
      VarianceCase ofMean(options, 2, VarianceOf::Mean);
      checkAgreement(ofMean, options);
    }
  }
}

TEST_CASE("variance of the mean is that of the samples over their number") {
  for (const CaseOptions& options : bothMappings()) {
    VarianceCase samples(options, 2);
    VarianceCase mean(options, 2, VarianceOf::Mean);
    const Planes variance = runVariance(samples);
    const Planes ofMean = runVariance(mean);
    for (std::size_t i = 0; i < variance.values.size(); ++i) {
      const double worth = std::max(double(mean.inputs.historyLength.values[i]), 1.0);
      CHECK(ofMean.values[i] == Approx(variance.values[i] / worth).epsilon(1e-6));
    }
  }
}

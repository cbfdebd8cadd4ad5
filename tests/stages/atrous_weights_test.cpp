// The weights of the stage atrous: what they sum to, and e^-x.
#include <cmath>

#include "tests/stages/atrous_checks.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

// Sum of the squares of a row's weights over the square of their sum, `taps` of five from the left on.
double squaredShare(int taps) {
  constexpr double kRow[] = {0.0625, 0.25, 0.375, 0.25, 0.0625};
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < taps; ++i) {
    sum += kRow[i];
    squares += kRow[i] * kRow[i];
  }
  return squares / (sum * sum);
}

}  // namespace

TEST_CASE("atrous keeps a constant: its weights sum to one") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    for (const float constant : {1.0f, 3.3f}) {
      AtrousCase atrous(options, {{1, false}, true, 3});
      fill(atrous.inputs.irradiance, constant);
      std::size_t kept = 0, holes = 0;
      // A pixel without a sample whose neighbours have none either stays black.
      for (const float value : filter(atrous).values)
        (value == 0.0f ? holes : kept) += value == 0.0f || std::abs(value / constant - 1.0f) < 1e-6f;
      CHECK(kept + holes == 3u * 61u * 40u);
      CHECK(kept > holes);
    }
  }
}

TEST_CASE("atrous lowers a constant variance by the squares of its weights") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    for (const int iteration : {1, 3}) {
      AtrousCase atrous(options, {{1, false}, true, iteration});
      flatten(atrous.inputs);
      fill(atrous.inputs.irradiance, 2.0f);
      fill(atrous.inputs.variance, 0.75f);
      filter(atrous);
      const Planes variance = atrous.variance();
      const double inside = squaredShare(5), atBorder = squaredShare(3);
      CHECK(variance.at(0, 30, 20) == Approx(0.75 * inside * inside).epsilon(1e-5));
      CHECK(variance.at(0, 0, 20) == Approx(0.75 * atBorder * inside).epsilon(1e-5));
      CHECK(variance.at(0, 30, 39) == Approx(0.75 * inside * atBorder).epsilon(1e-5));
      CHECK(variance.at(0, 60, 0) == Approx(0.75 * atBorder * atBorder).epsilon(1e-5));
    }
  }
}

TEST_CASE("atrous with 3x3 taps lowers a constant variance by the squares of its weights") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    AtrousCase atrous(options, ofQuell(3));
    flatten(atrous.inputs);
    fill(atrous.inputs.guides.roughness, 0.5f);
    fill(atrous.inputs.irradiance, 2.0f);
    fill(atrous.inputs.variance, 0.75f);
    for (const float value : filter(atrous).values) CHECK(value == Approx(2.0f).epsilon(1e-6));
    const Planes variance = atrous.variance();
    // 1/4, 1/2, 1/4; at the border without one of the outer two.
    const double inside = 6.0 / 16.0, atBorder = 5.0 / 9.0;
    for (const int signal : {0, 1}) {
      CHECK(variance.at(signal, 30, 20) == Approx(0.75 * inside * inside).epsilon(1e-5));
      CHECK(variance.at(signal, 0, 20) == Approx(0.75 * atBorder * inside).epsilon(1e-5));
      CHECK(variance.at(signal, 60, 39) == Approx(0.75 * atBorder * atBorder).epsilon(1e-5));
    }
  }
}

TEST_CASE("atrous without corners lowers a constant variance by the squares of its weights") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    for (const int iteration : {1, 4}) {
      AtrousCase atrous(options, ofQuell(iteration));
      flatten(atrous.inputs);
      fill(atrous.inputs.guides.roughness, 0.5f);
      fill(atrous.inputs.irradiance, 2.0f);
      fill(atrous.inputs.variance, 0.75f);
      for (const float value : filter(atrous).values) CHECK(value == Approx(2.0f).epsilon(1e-6));
      // 5x5: the squares of a row's weights sum to 70 / 256, the corners weigh 1 / 256 each. A cross: 1/4, four 1/8.
      const double sum = iteration == 1 ? 1.0 - 4.0 / 256.0 : 0.75;
      const double squares =
          iteration == 1 ? std::pow(70.0 / 256.0, 2.0) - 4.0 / 65536.0 : 1.0 / 16.0 + 4.0 / 64.0;
      const Planes variance = atrous.variance();
      for (const int signal : {0, 1})
        CHECK(variance.at(signal, 30, 20) == Approx(0.75 * squares / (sum * sum)).epsilon(1e-5));
    }
  }
}

TEST_CASE("the weight of a penalty is (1 - x/9)^8, close to e^-x, and 0 from 9 on") {
  // Pairs of pixels far apart, black and bright: what the black one gets tells the weight of the other. Only green is
  // lit, so that the penalty is known to the last bit.
  constexpr int kPitch = 5, kColumns = 80, kRows = 32;
  constexpr double kSteps = kColumns * kRows;
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    CaseOptions options;
    options.size = {kPitch * kColumns, kPitch * kRows};
    options.mapping = mapping;
    AtrousCase atrous(options, kWithoutVariance);
    AtrousInputs& inputs = atrous.inputs;
    flatten(inputs);
    fill(inputs.irradiance, 0.0f);
    forEachPixel(options.size,
                 [&](int x, int y) { inputs.guides.guides.at(QUELL_GUIDE_WEIGHT, x, y) = 0.0f; });
    const float unit = 1.0f / (float(inputs.luminanceSigma) + QUELL_LEAST_LUMINANCE_STEP);
    const auto eachPair = [&](const auto& work) {
      for (int i = 0; i < kColumns * kRows; ++i) {
        const float green = float(inputs.luminanceSigma / 0.7152 * 9.5 * (i + 1) / kSteps);
        work(kPitch * (i % kColumns), kPitch * (i / kColumns), green, 0.7152f * green * unit);
      }
    };
    eachPair([&](int x, int y, float green, float) {
      inputs.irradiance.at(1, x + 1, y) = green;
      for (const int column : {x, x + 1}) inputs.guides.guides.at(QUELL_GUIDE_WEIGHT, column, y) = 1.0f;
    });
    const Planes result = filter(atrous);
    double worst = 0.0, farthest = 0.0;
    std::size_t notZero = 0;
    eachPair([&](int x, int y, float green, float penalty) {
      const double got = result.at(1, x, y);
      // got = s w green / (1 + s w), s the ratio of the spline's weights.
      const double weight = got / (green - got) * (0.375 / 0.25);
      if (penalty < 9.0f)
        worst = std::max(worst, std::abs(weight - std::pow(1.0 - double(penalty) / 9.0, 8.0)));
      farthest = std::max(farthest, std::abs(weight - std::exp(-double(penalty))));
      if (penalty >= 9.0f) notZero += weight != 0.0;
    });
    INFO("largest error " << worst << ", distance from e^-x " << farthest);
    CHECK(worst < 1e-6);
    CHECK(farthest < 0.0271);
    CHECK(notZero == 0);
  }
}

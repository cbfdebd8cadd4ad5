#include <algorithm>
#include <cmath>

#include "tests/cases/atrous_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

// Two signals with a stop at roughness: every path of the kernel.
const AtrousVariant kEverything{{2, true}, true, 2};
const AtrousVariant kWithoutVariance{{1, false}, false, 1};
constexpr double kSharpRoughness = 0.6;

// Two signals, a stop at roughness, 3x3 taps from the second iteration on.
AtrousVariant ofQuell(int iteration, double sharpRoughness = kSharpRoughness) {
  return {{2, true}, true, iteration, sharpRoughness};
}

CaseMaker maker(const AtrousVariant& variant) {
  return [variant](const CaseOptions& options) { return std::make_unique<AtrousCase>(options, variant); };
}

void fill(Planes& planes, float value) { std::fill(planes.values.begin(), planes.values.end(), value); }

// One surface that faces the camera, with samples everywhere.
void flatten(AtrousInputs& inputs) {
  fill(inputs.guides.guides, 0.0f);
  fill(inputs.guides.viewDepth, 5.0f);
  forEachPixel(inputs.irradiance.size(), [&](int x, int y) {
    inputs.guides.guides.at(QUELL_GUIDE_NORMAL + 2, x, y) = 1.0f;
    for (int signal = 0; signal < inputs.signals(); ++signal)
      inputs.guides.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y) = 1.0f;
  });
}

void setIrradiance(AtrousInputs& inputs, int x, int y, float value) {
  for (int plane = 0; plane < inputs.irradiance.count; ++plane) inputs.irradiance.at(plane, x, y) = value;
}

Planes filter(AtrousCase& atrous) {
  atrous.upload();
  atrous.run();
  return atrous.irradiance();
}

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

TEST_CASE("atrous agrees with its oracle") { checkSizes(maker({})); }

TEST_CASE("atrous agrees with its oracle at all distances of taps") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const int iteration : {1, 2, 3, 4, 5}) {
      for (const Size size : {Size{1, 1}, Size{7, 93}, Size{33, 31}, Size{129, 67}}) {
        CaseOptions options;
        options.size = size;
        options.mapping = mapping;
        options.seed = unsigned(iteration);
        INFO("iteration " << iteration);
        AtrousCase guided(options, {{2, true}, true, iteration});
        CHECK(guided.inputs.step == 1 << (iteration - 1));
        checkAgreement(guided, options);
        AtrousCase plain(options, {{1, false}, false, iteration});
        checkAgreement(plain, options);
      }
    }
  }
}

TEST_CASE("atrous with fewer taps and a narrower stop on smooth surfaces agrees with its oracle") {
  for (const int iteration : {1, 2, 4, 5}) {
    for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
      for (const Size size : {Size{1, 1}, Size{7, 93}, Size{33, 31}, Size{129, 67}}) {
        CaseOptions options;
        options.size = size;
        options.mapping = mapping;
        options.seed = unsigned(iteration);
        INFO("iteration " << iteration);
        AtrousCase atrous(options, ofQuell(iteration));
        CHECK(atrous.inputs.radius == (iteration == 1 ? 2 : 1));
        CHECK(atrous.filtersVariance() == (iteration < 5));
        checkAgreement(atrous, options);
      }
    }
  }
}

TEST_CASE("atrous narrows the stop on luminance of the last signal, to a half at roughness 0") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    CaseOptions options;
    options.size = {61, 40};
    options.mapping = mapping;
    const auto run = [&](double sharpRoughness, float roughness, double deviation) {
      AtrousCase atrous(options, ofQuell(2, sharpRoughness));
      fill(atrous.inputs.guides.roughness, roughness);
      fill(atrous.inputs.variance, float(deviation * deviation));
      return filter(atrous);
    };
    CHECK(sameBits(run(kSharpRoughness, 0.7f, 0.5), run(0.0, 0.7f, 0.5)));
    const Planes sharp = run(kSharpRoughness, 0.0f, 0.5);
    const Planes wide = run(0.0, 0.0f, 0.5);
    CHECK(sameBits(planesOf(sharp, 0, 3), planesOf(wide, 0, 3)));
    CHECK_FALSE(sameBits(planesOf(sharp, 3, 3), planesOf(wide, 3, 3)));
    Comparison comparison;
    compareSignal(comparison, "glossy signal", sharp, 3, planesOf(run(0.0, 0.0f, 0.25), 3, 3));
    INFO(comparison.worst());
    CHECK(comparison.largestError() <= 1e-5);  // the least step in luminance is not halved
  }
}

TEST_CASE("atrous agrees with its oracle whichever images there are") {
  checkLayouts(maker({{1, true}, true, 3}), {packed(3)});
  checkLayouts(maker({{2, false}, false, 2}), {packed(3)});
}

TEST_CASE("atrous does not depend on the work-group") {
  checkWorkGroups(maker(kEverything), {"filteredEven", "varianceEven"});
  checkWorkGroups(maker(ofQuell(2)), {"filteredEven", "varianceEven"});
}

TEST_CASE("atrous of two signals equals two runs of one") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    CaseOptions options;
    options.size = {61, 40};
    options.mapping = mapping;
    AtrousCase both(options, kEverything);
    fill(both.inputs.guides.roughness, 0.5f);  // whose stop only the second signal has
    const Planes expected = filter(both);
    const Planes expectedVariance = both.variance();
    for (const int signal : {0, 1}) {
      AtrousCase one(options, {{1, false}, true, 2});
      one.inputs.guides = {
          guidesOfSignal(both.inputs.guides.guides, signal), both.inputs.guides.viewDepth, {}};
      one.inputs.irradiance = planesOf(both.inputs.irradiance, 3 * signal, 3);
      one.inputs.variance = planesOf(both.inputs.variance, signal, 1);
      Comparison comparison;
      compareSignal(comparison, "irradiance", expected, 3 * signal, filter(one));
      compareSignal(comparison, "variance", expectedVariance, signal, one.variance());
      INFO(comparison.worst());
      CHECK(comparison.largestError() <= 1e-6);
    }
  }
}

TEST_CASE("atrous keeps a constant: its weights sum to one") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const float constant : {1.0f, 3.3f}) {
      CaseOptions options;
      options.size = {61, 40};
      options.mapping = mapping;
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
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const int iteration : {1, 3}) {
      CaseOptions options;
      options.size = {61, 40};
      options.mapping = mapping;
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
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    CaseOptions options;
    options.size = {61, 40};
    options.mapping = mapping;
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
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const int iteration : {1, 4}) {
      CaseOptions options;
      options.size = {61, 40};
      options.mapping = mapping;
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

TEST_CASE("atrous fills holes from their neighbours and takes nothing from them") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const AtrousVariant& variant : {AtrousVariant(), kWithoutVariance}) {
      CaseOptions options;
      options.mapping = mapping;
      AtrousCase atrous(options, variant);
      flatten(atrous.inputs);
      fill(atrous.inputs.irradiance, 2.5f);
      for (const auto& [x, y] : {std::pair(0, 0), {15, 15}, {16, 15}, {32, 30}}) {
        setIrradiance(atrous.inputs, x, y, 6e4f);
        atrous.inputs.guides.guides.at(QUELL_GUIDE_WEIGHT, x, y) = 0.0f;
      }
      for (const float value : filter(atrous).values) CHECK(value == Approx(2.5).epsilon(1e-6));
    }
  }
}

TEST_CASE("atrous lets nothing across an edge") {
  enum class Edge { Normal, Depth, Luminance, Roughness };
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const Edge edge : {Edge::Normal, Edge::Depth, Edge::Luminance, Edge::Roughness}) {
      CaseOptions options;
      options.mapping = mapping;
      AtrousCase atrous(options, {{1, true}, true, 2});
      AtrousInputs& inputs = atrous.inputs;
      flatten(inputs);
      fill(inputs.guides.roughness, 0.5f);
      fill(inputs.variance, edge == Edge::Luminance ? 1e-4f : 1e6f);
      const int firstRight = 13;
      forEachPixel(options.size, [&](int x, int y) {
        const bool right = x >= firstRight;
        setIrradiance(inputs, x, y, right ? 3.0f : 1.0f);
        if (edge == Edge::Normal && right) {
          inputs.guides.guides.at(QUELL_GUIDE_NORMAL, x, y) = 1.0f;
          inputs.guides.guides.at(QUELL_GUIDE_NORMAL + 2, x, y) = 0.0f;
        }
        if (edge == Edge::Depth && right) inputs.guides.viewDepth.at(0, x, y) = 6.0f;
        if (edge == Edge::Roughness) inputs.guides.roughness.at(0, x, y) = right ? 0.95f : 0.04f;
      });
      const Planes result = filter(atrous);
      INFO("edge " << int(edge));
      std::size_t leftErrors = 0, rightErrors = 0;
      forEachPixel(options.size, [&](int x, int y) {
        const bool right = x >= firstRight;
        (right ? rightErrors : leftErrors) += std::abs(result.at(0, x, y) - (right ? 3.0f : 1.0f)) > 1e-5f;
      });
      CHECK(leftErrors == 0);
      // Relative to the rougher side the step is small: that side does let the other in.
      CHECK((rightErrors > 0) == (edge == Edge::Roughness));
    }
  }
}

TEST_CASE("atrous stays within the range of its inputs, however extreme") {
  constexpr float kExtremes[] = {0.0f, 1e-45f, 1e-38f, 1e-20f, 1e-3f, 65504.0f};
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const AtrousVariant& variant : {kEverything, kWithoutVariance}) {
      CaseOptions options;
      options.size = {61, 40};
      options.mapping = mapping;
      AtrousCase atrous(options, variant);
      AtrousInputs& inputs = atrous.inputs;
      Random random(3);
      const auto extreme = [&] { return kExtremes[random.integer(0, int(std::size(kExtremes)) - 1)]; };
      for (float& value : inputs.irradiance.values) value = extreme();
      for (float& value : inputs.variance.values) value = extreme() * 65504.0f;
      for (float& value : inputs.guides.roughness.values) value = std::min(extreme(), 1.0f);
      forEachPixel(options.size, [&](int x, int y) {
        inputs.guides.viewDepth.at(0, x, y) = random.uniform() < 0.1 ? 1e18f : extreme();
        for (int axis = 0; axis < 3; ++axis)
          inputs.guides.guides.at(QUELL_GUIDE_NORMAL + axis, x, y) = float(random.uniform(-1.1, 1.1));
      });
      std::size_t bad = 0;
      for (const float value : filter(atrous).values)
        bad += !(value >= 0.0f && value <= 65504.0f * 1.000001f);
      if (variant.variance) {
        for (const float value : atrous.variance().values)
          bad += !(value >= 0.0f && value <= 65504.0f * 65504.0f * 1.00001f);
      }
      CHECK(bad == 0);
    }
  }
}

TEST_CASE("the weight of a penalty is e^-x to one part in 10^5, and 0 from 20 on") {
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
        const float green = float(inputs.luminanceSigma / 0.7152 * 20.5 * (i + 1) / kSteps);
        work(kPitch * (i % kColumns), kPitch * (i / kColumns), green, 0.7152f * green * unit);
      }
    };
    eachPair([&](int x, int y, float green, float) {
      inputs.irradiance.at(1, x + 1, y) = green;
      for (const int column : {x, x + 1}) inputs.guides.guides.at(QUELL_GUIDE_WEIGHT, column, y) = 1.0f;
    });
    const Planes result = filter(atrous);
    double worst = 0.0;
    std::size_t notZero = 0;
    eachPair([&](int x, int y, float green, float penalty) {
      const double got = result.at(1, x, y);
      // got = s w green / (1 + s w), s the ratio of the spline's weights.
      const double weight = got / (green - got) * (0.375 / 0.25);
      if (penalty < 20.0f) worst = std::max(worst, std::abs(weight / std::exp(-double(penalty)) - 1.0));
      if (penalty >= 20.0f) notZero += weight != 0.0;
    });
    INFO("largest relative error " << worst);
    CHECK(worst < 1e-5 + 5e-7);  // of the series, and of the rounding on the way
    CHECK(notZero == 0);
  }
}

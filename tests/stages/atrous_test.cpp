#include <algorithm>
#include <cmath>

#include "tests/stages/atrous_checks.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

// Two signals with a stop at roughness: every path of the kernel.
const AtrousVariant kEverything{{2, true}, true, 2};
CaseMaker maker(const AtrousVariant& variant) {
  return [variant](const CaseOptions& options) { return std::make_unique<AtrousCase>(options, variant); };
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

TEST_CASE("atrous writes no variance in the last iteration, which nobody reads") {
  for (const CaseOptions& options : bothMappings({33, 17})) {
    AtrousCase last(options, ofQuell(5));
    const Planes before = randomPlanes(options.size, last.inputs.variance.count, 1, 0.0, 1.0);
    last.upload();
    last.setVariance(before);
    last.run();
    CHECK_FALSE(last.filtersVariance());
    CHECK(sameBits(last.variance(), before));
  }
}

TEST_CASE("atrous narrows the stop on luminance of the last signal, to a half at roughness 0") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
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

TEST_CASE("atrous leaves out background") {
  for (const AtrousVariant& variant : {kEverything, ofQuell(1), ofQuell(4)}) checkHoles(maker(variant));
}

TEST_CASE("atrous leaves out background in further variants", "[.long]") {
  for (const AtrousVariant& variant : {kWithoutVariance, ofQuell(2)}) checkHoles(maker(variant));
}

TEST_CASE("atrous does not depend on the work-group") {
  checkWorkGroups(maker(kEverything), {"filteredIrradiance", "filteredVariance"});
  checkWorkGroups(maker(ofQuell(2)), {"filteredIrradiance", "filteredVariance"});
}

TEST_CASE("atrous of two signals equals two runs of one") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
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

TEST_CASE("atrous fills holes from their neighbours and takes nothing from them") {
  for (const CaseOptions& options : bothMappings()) {
    for (const AtrousVariant& variant : {AtrousVariant(), kWithoutVariance}) {
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
  for (const CaseOptions& options : bothMappings()) {
    for (const Edge edge : {Edge::Normal, Edge::Depth, Edge::Luminance, Edge::Roughness}) {
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
  for (const CaseOptions& options : bothMappings({61, 40})) {
    for (const AtrousVariant& variant : {kEverything, kWithoutVariance}) {
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

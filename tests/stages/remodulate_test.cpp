#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "host/methods/setting_table.hpp"
#include "host/metrics/display_encoding.hpp"
#include "kernels/accumulate_noisy_params.h"
#include "tests/cases/demodulate_case.hpp"
#include "tests/cases/remodulate_case.hpp"
#include "tests/oracle/display_encoding_oracle.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(const MaterialVariant& variant, RemodulateTo to = RemodulateTo::Antialiasing) {
  return [variant, to](const CaseOptions& options) {
    return std::make_unique<RemodulateCase>(options, variant, to);
  };
}

// The display image of these values of background, one a pixel; channels are `tint` of them.
Planes show(const std::vector<float>& values, Mapping mapping, const std::array<float, 3>& tint,
            const DisplayTransform& transform) {
  CaseOptions options;
  options.size = {int(values.size()), 1};
  options.mapping = mapping;
  RemodulateCase remodulate(options, kPlainMaterial, RemodulateTo::Outputs, LightLoss::Left, transform);
  std::fill(remodulate.inputs.guides.values.begin(), remodulate.inputs.guides.values.end(), 0.0f);
  for (int x = 0; x < options.size.width; ++x)
    for (int c = 0; c < 3; ++c)
      remodulate.inputs.material.radiance.at(x, 0, c) = values[std::size_t(x)] * tint[std::size_t(c)];
  remodulate.uploadAndRun();
  return remodulate.display();
}

// Encodes these values of background as grey.
std::vector<float> encode(const std::vector<float>& values, Mapping mapping) {
  const Planes encoded = show(values, mapping, {1.0f, 1.0f, 1.0f}, {});
  return {encoded.values.begin(), encoded.values.begin() + encoded.width};
}

// The spacing of halves at this value.
double halfUlp(double value) { return std::exp2(std::floor(std::log2(std::max(value, 1e-4))) - 10.0); }

// Factors at and beyond the ends of their range, in all channels or in one.
void spreadFactors(io::Image& factor) {
  const float values[] = {0.0f,  1e-7f, 1e-4f, 0.0099f, 0.01f, 0.0101f,
                          0.02f, 1.5f,  50.0f, 1e30f,   -0.5f, std::numeric_limits<float>::quiet_NaN()};
  constexpr std::size_t kValues = std::size(values);
  const std::size_t pixels = factor.pixels.size() / 3;
  for (std::size_t i = 0; i < pixels; i += 3) {
    const float value = values[i / 3 % kValues];
    const std::size_t channels = i / 3 / kValues % 2 == 0 ? 3 : 1;
    for (std::size_t c = 0; c < channels; ++c) factor.pixels[3 * i + c] = value;
  }
}

}  // namespace

TEST_CASE("remodulate agrees with its oracle") { checkSizes(maker(kFullMaterial)); }

TEST_CASE("remodulate of two signals agrees with its oracle") { checkSizes(maker(kTwoSignals)); }

TEST_CASE("remodulate agrees with its oracle whichever images there are") {
  const MaterialVariant variants[] = {kPlainMaterial,
                                      kDemodulatedMaterial,
                                      {false, true, false, false},
                                      {false, false, true, false},
                                      kUndividedMaterial,
                                      kMaterialWithF0,
                                      kTwoDemodulatedSignals,
                                      {false, false, false, false, true}};
  std::vector<CaseMaker> makers;
  for (const MaterialVariant& variant : variants) makers.push_back(maker(variant));
  checkVariants(makers);
}

TEST_CASE("remodulate leaves the linear image of jittered rays to antialiasing") {
  checkVariants({maker(kFullMaterial, RemodulateTo::AntialiasingOnly)});
  RemodulateCase remodulate({}, kFullMaterial, RemodulateTo::AntialiasingOnly);
  CHECK_FALSE(remodulate.harness().hasPort("linear"));
}

TEST_CASE("remodulate gives light back") {
  const auto giveBack = [](const MaterialVariant& variant, RemodulateTo to) -> CaseMaker {
    return [variant, to](const CaseOptions& options) {
      return std::make_unique<RemodulateCase>(options, variant, to, LightLoss::GivenBack);
    };
  };
  checkSizes(giveBack(kTwoSignals, RemodulateTo::Antialiasing));
  checkHoles(giveBack(kFullMaterial, RemodulateTo::Outputs));
  checkWorkGroups(giveBack(kTwoSignals, RemodulateTo::Antialiasing), {"beforeAntialiasing"});
}

TEST_CASE("remodulate with a gain of 0 changes no bit") {
  for (const CaseOptions& options : bothMappings()) {
    RemodulateCase left(options, kTwoSignals),
        givenBack(options, kTwoSignals, RemodulateTo::Antialiasing, LightLoss::GivenBack);
    fill(givenBack.inputs.lightGain, 0.0f);
    left.uploadAndRun();
    givenBack.uploadAndRun();
    CHECK(sameBits(left.linear(), givenBack.linear()));
  }
}

TEST_CASE("remodulate reads and writes every layout") {
  checkLayouts(maker(kFullMaterial, RemodulateTo::Outputs), outputLayouts());
}

TEST_CASE("remodulate leaves out background") {
  checkHoles(maker(kTwoSignals));
  checkHoles(maker(kFullMaterial, RemodulateTo::Outputs));
}

TEST_CASE("remodulate does not depend on the work-group") {
  checkWorkGroups(maker(kFullMaterial), {"beforeAntialiasing"});
}

TEST_CASE("remodulate encodes 0 and 1 as themselves, clamps, and rises along a ramp") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    std::vector<float> ramp;
    for (int i = 0; i <= 4096; ++i) ramp.push_back(float(i) / 4096.0f);
    ramp.push_back(2.0f);
    const std::vector<float> encoded = encode(ramp, mapping);
    CHECK(encoded.front() == 0.0f);
    CHECK(encoded[4096] == Approx(1.0).margin(kEncodingTolerance));
    CHECK(encoded[4096] <= 1.0f);
    CHECK(encoded.back() == encoded[4096]);
    CHECK(std::is_sorted(encoded.begin(), encoded.end()));
    double worst = 0.0;
    for (std::size_t i = 0; i < ramp.size(); ++i)
      worst = std::max(worst, std::abs(encoded[i] - encodeDisplayExact(ramp[i])));
    CHECK(worst <= kEncodingTolerance);
  }
}

TEST_CASE("remodulate shows light through every tone map and encoding, exposed") {
  const DisplayTransform transforms[] = {{ToneMap::Reinhard, DisplayEncoding::Srgb, 1.5},
                                         {ToneMap::Aces, DisplayEncoding::Linear, -0.5},
                                         {ToneMap::None, DisplayEncoding::Gamma, 2.0},
                                         {ToneMap::None, DisplayEncoding::Linear, 32.0}};
  const std::array<float, 3> tint{1.0f, 0.5f, 0.25f};
  std::vector<float> values{0.0f};
  for (float value = 1e-6f; value < 60000.0f; value *= 1.5f) values.push_back(value);
  for (const DisplayTransform& transform : transforms) {
    INFO(choiceName(transform.toneMap) << ", " << choiceName(transform.encoding));
    const Planes shown = show(values, Mapping::Wide, tint, transform);
    double worst = 0.0;
    for (int x = 0; x < shown.width; ++x) {
      const double value = double(values[std::size_t(x)]);
      const auto exact = metrics::displayed({value, 0.5 * value, 0.25 * value}, transform);
      for (int c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(double(shown.at(c, x, 0)) - exact[std::size_t(c)]) /
                                    std::max(1.0, exact[std::size_t(c)]));
    }
    CHECK(worst <= 1.5 * kEncodingTolerance);
  }
}

TEST_CASE("remodulate encodes any input into [0, 1]") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const float value : encode(adversarialValues(), mapping)) {
      CHECK(value >= 0.0f);
      CHECK(value <= 1.0f);
    }
  }
}

TEST_CASE("demodulate then remodulate is the identity to one unit in the last place of a half") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const MaterialVariant& variant : {kFullMaterial, kTwoSignals, kUndividedMaterial}) {
      CaseOptions options;
      options.mapping = mapping;
      options.layout = packedHalf(3);
      DemodulateCase demodulate(options, {variant});
      MaterialImages& material = demodulate.inputs.material;
      spreadFactors(material.albedo);
      spreadFactors(material.glossColor);
      material.radiance = asStored(material.radiance, makeView(options.layout, options.size));
      for (std::size_t i = 0; i < material.radiance.pixels.size(); ++i)
        material.emission.pixels[i] = 0.5f * material.radiance.pixels[i];
      demodulate.uploadAndRun();
      RemodulateCase remodulate(options, variant);
      remodulate.inputs = {material, demodulate.irradiance(), demodulate.guides()};
      remodulate.uploadAndRun();
      const io::Image result = remodulate.harness().output(&Output::linear);
      double worst = 0.0;
      for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        double expected = material.radiance.pixels[i];
        if (variant.twoSignals) expected += double(material.glossyRadiance.pixels[i]);
        worst = std::max(worst, std::abs(result.pixels[i] - expected) / halfUlp(expected));
      }
      CHECK(worst <= 1.0);
    }
  }
}

TEST_CASE("remodulate passes through what is not filtered: no surface, or a sample without weight") {
  for (const int plane : {QUELL_GUIDE_NORMAL, QUELL_GUIDE_WEIGHT}) {
    RemodulateCase remodulate({});
    Planes& guides = remodulate.inputs.guides;
    for (int p = plane; p < (plane == QUELL_GUIDE_NORMAL ? plane + 3 : plane + 1); ++p)
      forEachPixel(remodulate.size(), [&](int x, int y) { guides.at(p, x, y) = 0.0f; });
    remodulate.uploadAndRun();
    const Planes linear = remodulate.linear();
    forEachPixel(remodulate.size(), [&](int x, int y) {
      for (int c = 0; c < 3; ++c)
        CHECK(linear.at(c, x, y) ==
              Approx(remodulate.inputs.material.radiance.at(x, y, c)).epsilon(kRemodulateTolerance));
    });
  }
}

TEST_CASE("remodulate adds no more emission than radiance has") {
  RemodulateCase remodulate({});
  MaterialImages& material = remodulate.inputs.material;
  for (float& value : material.emission.pixels) value = 10.0f;
  for (float& value : material.radiance.pixels) value = 1.0f;
  for (float& value : remodulate.inputs.filtered.values) value = 0.0f;
  remodulate.uploadAndRun();
  for (const float value : remodulate.linear().values) CHECK(value == 1.0f);
  // A missing sample says nothing about it.
  for (float& value : material.radiance.pixels) value = std::numeric_limits<float>::quiet_NaN();
  remodulate.uploadAndRun();
  for (const float value : remodulate.linear().values) CHECK(value == 10.0f);
}

TEST_CASE("remodulate gives finite values for any input, and bad pixels do not leak") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    RemodulateCase remodulate(options, kTwoSignals);
    remodulate.uploadAndRun();
    const Planes clean = remodulate.linear();
    BasicPlanes<char> spoiled(options.size, 1);
    auto& material = remodulate.inputs.material;
    unsigned seed = 7;
    for (io::Image* image : {&material.radiance, &material.glossyRadiance, &material.emission,
                             &material.albedo, &material.glossColor})
      spoil(*image, seed++, 12, &spoiled);
    checkAgreement(remodulate, options);
    const Planes dirty = remodulate.linear();
    CHECK(allFinite(dirty));
    CHECK(sameBits(clean, dirty, &spoiled));
  }
}

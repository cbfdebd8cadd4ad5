#include <algorithm>

#include "kernels/accumulate_noisy_params.h"
#include "tests/cases/remodulate_case.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(const MaterialVariant& variant) {
  return [variant](const CaseOptions& options) { return std::make_unique<RemodulateCase>(options, variant); };
}

}  // namespace

TEST_CASE("remodulate agrees with its oracle") { checkSizes(maker(kFullMaterial)); }

TEST_CASE("remodulate agrees with its oracle whichever images there are") {
  const MaterialVariant variants[] = {
      kPlainMaterial, kDemodulatedMaterial, {false, true, false, false}, {false, false, true, false}};
  for (const MaterialVariant& variant : variants) checkLayouts(maker(variant), {packed(3)});
}

TEST_CASE("remodulate reads and writes every layout") { checkLayouts(maker(kFullMaterial), outputLayouts()); }

TEST_CASE("remodulate does not depend on the work-group") {
  checkWorkGroups(maker(kFullMaterial), {"linear"});
}

TEST_CASE("demodulate then remodulate is the identity") {
  // Where a channel tells about the light (factor >= 0.01), and equally where it does not.
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    CaseOptions options;
    options.mapping = mapping;
    RemodulateCase remodulate(options);
    auto& inputs = remodulate.inputs;
    inputs.material.emission = io::Image(options.size.width, options.size.height, 3);
    for (float& value : inputs.material.albedo.pixels) value = value < 0.01f ? 0.0f : value;
    inputs.material.glossColor = io::Image(options.size.width, options.size.height, 3);
    forEachPixel(options.size, [&](int x, int y) {
      const Material material = materialAt(inputs.material, x, y);
      const Irradiance irradiance = demodulate(material);
      for (int c = 0; c < 3; ++c) inputs.filtered.at(c, x, y) = float(irradiance.value[c]);
    });
    remodulate.upload();
    remodulate.run();
    const Planes linear = remodulate.linear();
    Comparison comparison;
    forEachPixel(options.size, [&](int x, int y) {
      for (int c = 0; c < 3; ++c)
        comparison.include("radiance", c, x, y, linear.at(c, x, y), inputs.material.radiance.at(x, y, c));
    });
    INFO(comparison.worst());
    CHECK(comparison.largestError() <= kRemodulateTolerance);
  }
}

TEST_CASE("remodulate passes background and black materials through") {
  RemodulateCase remodulate({});
  auto& material = remodulate.inputs.material;
  for (float& value : material.albedo.pixels) value = 0.0f;
  for (float& value : material.glossColor.pixels) value = 0.0f;
  remodulate.upload();
  remodulate.run();
  const Planes linear = remodulate.linear();
  forEachPixel(remodulate.size(), [&](int x, int y) {
    for (int c = 0; c < 3; ++c) {
      const double radiance = std::max(material.radiance.at(x, y, c), material.emission.at(x, y, c));
      CHECK(linear.at(c, x, y) == Approx(radiance).epsilon(kRemodulateTolerance));
    }
  });
}

TEST_CASE("remodulate gives finite values for any input, and bad pixels do not leak") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    CaseOptions options;
    options.size = {61, 40};
    options.mapping = mapping;
    RemodulateCase remodulate(options);
    remodulate.upload();
    remodulate.run();
    const Planes clean = remodulate.linear();
    BasicPlanes<char> spoiled(options.size, 1);
    auto& material = remodulate.inputs.material;
    unsigned seed = 7;
    for (io::Image* image : {&material.radiance, &material.emission, &material.albedo, &material.glossColor})
      spoil(*image, seed++, 12, &spoiled);
    checkAgreement(remodulate, options);
    const Planes dirty = remodulate.linear();
    CHECK(allFinite(dirty));
    CHECK(sameBits(clean, dirty, &spoiled));
  }
}

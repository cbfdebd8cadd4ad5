#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/stages/accumulate_noisy_checks.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/stage_checks.hpp"
#include "tests/support/test_scene.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

CaseMaker maker(const AccumulateNoisyVariant& variant = {}) {
  return [variant](const CaseOptions& options) {
    return std::make_unique<AccumulateNoisyCase>(options, variant);
  };
}

std::vector<const Planes*> allOutputs(const AccumulateNoisyOutputs<float>& o) {
  return {&o.irradiance, &o.historyLength, &o.guides,    &o.pixelPrev,        &o.reprojectionMask, &o.moments,
          &o.viewDepth,  &o.roughness,     &o.objectIds, &o.newestIrradiance, &o.innovation};
}

// What a run with this signal alone would get.
AccumulateNoisyInputs inputsOfSignal(const AccumulateNoisyInputs& both, int signal) {
  AccumulateNoisyInputs one = both;
  one.material.glossyRadiance = io::Image();
  one.roughness = io::Image();
  if (signal == 0) {
    one.material.glossColor = io::Image();
  } else {
    one.material.radiance = both.material.glossyRadiance;
    one.material.albedo = io::Image();
    one.material.emission = io::Image();
  }
  one.irradiancePrev = planesOf(both.irradiancePrev, 3 * signal, 3);
  one.historyLengthPrev = planesOf(both.historyLengthPrev, signal, 1);
  one.momentsPrev = planesOf(both.momentsPrev, QUELL_MOMENT_PLANES * signal, QUELL_MOMENT_PLANES);
  one.guidesPrev = guidesOfSignal(both.guidesPrev, signal);
  return one;
}

// So near that history is shared among neighbours.
TestCamera slightlyMovedCamera() {
  TestCamera camera;
  camera.x += 0.001;
  camera.y += 0.001;
  return camera;
}

const AccumulateNoisyVariant kMotionAndObjects{kPlainMaterial, false, false, false, true, true};

}  // namespace

TEST_CASE("accumulate_noisy agrees with its oracle") { checkSizes(maker()); }

TEST_CASE("accumulate_noisy agrees with its oracle for two signals, moments and guides of filters") {
  checkSizes(maker(kEverything));
}

TEST_CASE("accumulate_noisy agrees with its oracle whichever images there are") {
  const AccumulateNoisyVariant variants[] = {{kPlainMaterial, true},
                                             {kDemodulatedMaterial, false},
                                             {{false, true, false, false}, false},
                                             {{false, false, true, false}, true},
                                             {kUndividedMaterial},
                                             {kTwoDemodulatedSignals, false, true, true},
                                             {{false, false, false, false, true}, true, true, false},
                                             {{true, true, true, false, true, false}, false, true, true}};
  std::vector<CaseMaker> makers;
  for (const AccumulateNoisyVariant& variant : variants) makers.push_back(maker(variant));
  checkVariants(makers);
}

TEST_CASE("accumulate_noisy finds background") {
  for (const AccumulateNoisyVariant& variant : {AccumulateNoisyVariant(), kEverything, kMotionAndObjects})
    checkHoles(maker(variant));
}

// material_guides and remodulate read all others, through the same functions.
TEST_CASE("accumulate_noisy reads layouts of all kinds") {
  checkLayouts(maker(), {packed(1), packed(2), packedHalf(3), interleaved(4, ComponentFormat::Float16)});
}

TEST_CASE("accumulate_noisy does not depend on the work-group") {
  checkWorkGroups(maker(kEverything),
                  {"irradiance", "historyLength", "guides", "pixelPrev", "reprojectionMask", "moments",
                   "viewDepth", "roughness", "newestIrradiance", "innovation"});
}

TEST_CASE("accumulate_noisy of two signals equals two runs of one") {
  CaseOptions options;
  options.size = {61, 40};
  AccumulateNoisyCase both(options, kEverything);
  // A weak channel is another kind of pixel where it is the only signal's, but not where it is one of two signals'.
  for (io::Image* factor : {&both.inputs.material.albedo, &both.inputs.material.glossColor})
    for (float& value : factor->pixels) value = std::max(value, 0.02f);
  both.uploadAndRun();
  const auto expected = both.outputs();
  const MaterialVariant alone[] = {{true, true, false}, {false, false, true}};
  for (const int signal : {0, 1}) {
    AccumulateNoisyCase one(options, {alone[signal], false, true, false, false, false, true});
    one.inputs = inputsOfSignal(both.inputs, signal);
    one.uploadAndRun();
    const auto outputs = one.outputs();
    Comparison comparison;
    compareSignal(comparison, "irradiance", expected.irradiance, 3 * signal, outputs.irradiance);
    compareSignal(comparison, "moments", expected.moments, QUELL_MOMENT_PLANES * signal, outputs.moments);
    compareSignal(comparison, "historyLength", expected.historyLength, signal, outputs.historyLength);
    compareSignal(comparison, "mask", expected.reprojectionMask, signal, outputs.reprojectionMask);
    compareSignal(comparison, "weight", expected.guides, QUELL_GUIDE_WEIGHT + signal,
                  planesOf(outputs.guides, QUELL_GUIDE_WEIGHT, 1));
    compareSignal(comparison, "guides", expected.guides, 0, planesOf(outputs.guides, 0, QUELL_GUIDE_WEIGHT));
    INFO(comparison.worst());
    CHECK(comparison.largestError() <= kAccumulateNoisyTolerance);
  }
}

TEST_CASE("accumulate_noisy: a broken glossy sample leaves the diffuse signal alone") {
  CaseOptions options;
  options.size = {61, 40};
  AccumulateNoisyCase noisy(options, kEverything);
  noisy.uploadAndRun();
  const auto clean = noisy.outputs();
  spoil(noisy.inputs.material.glossyRadiance, 5, 4);
  noisy.uploadAndRun();
  const auto dirty = noisy.outputs();
  CHECK(sameBits(planesOf(clean.irradiance, 0, 3), planesOf(dirty.irradiance, 0, 3)));
  CHECK(sameBits(planesOf(clean.moments, 0, 2), planesOf(dirty.moments, 0, 2)));
  CHECK(sameBits(planesOf(clean.historyLength, 0, 1), planesOf(dirty.historyLength, 0, 1)));
  CHECK(sameBits(planesOf(clean.guides, 0, 7), planesOf(dirty.guides, 0, 7)));
  CHECK_FALSE(sameBits(planesOf(clean.historyLength, 1, 1), planesOf(dirty.historyLength, 1, 1)));
}

TEST_CASE("accumulate_noisy takes materials that fade to black") {
  // Albedos from 1 down to the smallest denormal; in the next frame the pixels live on their faint history
  // alone.
  for (const CaseOptions& options : bothMappings({184, 31})) {
    AccumulateNoisyCase noisy(options, {{false, true, false, false}, false});
    auto& albedo = noisy.inputs.material.albedo;
    forEachPixel(options.size, [&](int x, int y) {
      for (int c = 0; c < 3; ++c) albedo.at(x, y, c) = float(std::pow(10.0, -0.25 * x));
    });
    checkAgreement(noisy, options);
    const auto first = noisy.outputs();
    for (const float value : first.irradiance.values) CHECK(value <= QUELL_MAX_RADIANCE);
    noisy.inputs.irradiancePrev = first.irradiance;
    noisy.inputs.historyLengthPrev = first.historyLength;
    noisy.inputs.guidesPrev = first.guides;
    for (float& value : noisy.inputs.material.radiance.pixels)
      value = std::numeric_limits<float>::quiet_NaN();
    noisy.useReprojection(makeReprojection({}, slightlyMovedCamera(), options.size));
    checkAgreement(noisy, options);
    const auto second = noisy.outputs();
    for (const Planes* output : allOutputs(second)) CHECK(allFinite(*output));
    for (const float value : second.irradiance.values) CHECK(value <= QUELL_MAX_RADIANCE);
  }
}

TEST_CASE("accumulate_noisy gives finite values for any input, and bad pixels do not leak") {
  for (const CaseOptions& options : bothMappings({61, 40})) {
    for (const AccumulateNoisyVariant& variant : {AccumulateNoisyVariant(), kEverything, kMotionAndObjects}) {
      AccumulateNoisyCase noisy(options, variant);
      noisy.uploadAndRun();
      const auto clean = noisy.outputs();
      BasicPlanes<char> spoiled(options.size, 1);
      auto& inputs = noisy.inputs;
      auto& material = inputs.material;
      unsigned seed = 7;
      for (io::Image* image :
           {&material.radiance, &material.emission, &material.albedo, &material.glossColor, &inputs.normal,
            &inputs.position, &material.glossyRadiance, &inputs.roughness, &inputs.motion})
        if (!image->empty()) spoil(*image, seed++, 16, &spoiled);
      checkAgreement(noisy, options);
      const auto dirty = noisy.outputs();
      for (std::size_t i = 0; i < allOutputs(clean).size(); ++i) {
        CHECK(allFinite(*allOutputs(dirty)[i]));
        CHECK(sameBits(*allOutputs(clean)[i], *allOutputs(dirty)[i], &spoiled));
      }
    }
  }
}

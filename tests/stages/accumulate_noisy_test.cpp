#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/cases/accumulate_noisy_case.hpp"
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

// The camera stands still; the frame before showed the same surfaces.
void standStill(AccumulateNoisyCase& noisy, float historyLength) {
  noisy.useReprojection(makeReprojection({}, {}, noisy.size()));
  noisy.inputs.guidesPrev = renderScene({}, noisy.size()).guides;
  for (float& length : noisy.inputs.historyLengthPrev.values) length = historyLength;
}

void fill(Planes& planes, float value) { std::fill(planes.values.begin(), planes.values.end(), value); }

bool isSurface(const Planes& guides, int x, int y) { return guides.at(QUELL_GUIDE_WEIGHT, x, y) > 0.0f; }

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

const AccumulateNoisyVariant kPlain{kPlainMaterial};
const AccumulateNoisyVariant kPlainWithMoments{kPlainMaterial, false, true};
const AccumulateNoisyVariant kEverything{kTwoSignals, false, true, true, false, false, true};
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
  both.upload();
  both.run();
  const auto expected = both.outputs();
  const MaterialVariant alone[] = {{true, true, false}, {false, false, true}};
  for (const int signal : {0, 1}) {
    AccumulateNoisyCase one(options, {alone[signal], false, true, false, false, false, true});
    one.inputs = inputsOfSignal(both.inputs, signal);
    one.upload();
    one.run();
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
  noisy.upload();
  noisy.run();
  const auto clean = noisy.outputs();
  spoil(noisy.inputs.material.glossyRadiance, 5, 4);
  noisy.upload();
  noisy.run();
  const auto dirty = noisy.outputs();
  CHECK(sameBits(planesOf(clean.irradiance, 0, 3), planesOf(dirty.irradiance, 0, 3)));
  CHECK(sameBits(planesOf(clean.moments, 0, 2), planesOf(dirty.moments, 0, 2)));
  CHECK(sameBits(planesOf(clean.historyLength, 0, 1), planesOf(dirty.historyLength, 0, 1)));
  CHECK(sameBits(planesOf(clean.guides, 0, 7), planesOf(dirty.guides, 0, 7)));
  CHECK_FALSE(sameBits(planesOf(clean.historyLength, 1, 1), planesOf(dirty.historyLength, 1, 1)));
}

TEST_CASE("accumulate_noisy without history is the plain sample") {
  for (const bool frameBefore : {false, true}) {
    CaseOptions options;
    options.size = {61, 40};
    AccumulateNoisyCase noisy(options, kPlain);
    noisy.useReprojection(makeReprojection({}, {}, options.size, frameBefore));
    forEachPixel(options.size,
                 [&](int x, int y) { noisy.inputs.guidesPrev.at(QUELL_GUIDE_WEIGHT, x, y) = 0.0f; });
    noisy.upload();
    noisy.run();
    const auto outputs = noisy.outputs();
    forEachPixel(options.size, [&](int x, int y) {
      const bool surface = isSurface(outputs.guides, x, y);
      CHECK(outputs.reprojectionMask.at(0, x, y) == (frameBefore ? float(QUELL_PREV_IN_FRAME) : 0.0f));
      CHECK(outputs.historyLength.at(0, x, y) == (surface ? 1.0f : 0.0f));
      for (int c = 0; c < 3; ++c) {
        const double expected = surface ? noisy.inputs.material.radiance.at(x, y, c) : 0.0;
        CHECK(outputs.irradiance.at(c, x, y) == Approx(expected).margin(8.0 * kAccumulateNoisyTolerance));
      }
    });
  }
}

TEST_CASE("accumulate_noisy of a still camera lands on pixel centres") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    CaseOptions options;
    options.size = {480, 270};
    options.mapping = mapping;
    AccumulateNoisyCase noisy(options);
    standStill(noisy, 1.0f);
    noisy.upload();
    noisy.run();
    const Planes pixelPrev = noisy.outputs().pixelPrev;
    std::size_t elsewhere = 0;
    forEachPixel(options.size, [&](int x, int y) {
      elsewhere += pixelPrev.at(0, x, y) != float(x) || pixelPrev.at(1, x, y) != float(y);
    });
    CHECK(elsewhere == 0);
  }
}

TEST_CASE("accumulate_noisy averages static frames until the weight hits the floor") {
  CaseOptions options;
  options.size = {33, 31};
  AccumulateNoisyCase noisy(options, kPlainWithMoments);
  const int framesToFloor = int(1.0 / noisy.inputs.leastWeight);
  const int x = 10, y = 25;  // on a surface
  double expected = 0.0, mean = 0.0, first = 0.0, second = 0.0;
  for (int frame = 1; frame <= framesToFloor + 4; ++frame) {
    standStill(noisy, float(frame - 1));
    if (frame == 1) noisy.useReprojection(makeReprojection({}, {}, options.size, false));
    const double sample = 1.0 + (frame * 7 % 5);
    std::fill(noisy.inputs.material.radiance.pixels.begin(), noisy.inputs.material.radiance.pixels.end(),
              float(sample));
    noisy.upload();
    noisy.run();
    const auto outputs = noisy.outputs();
    noisy.inputs.irradiancePrev = outputs.irradiance;
    noisy.inputs.momentsPrev = outputs.moments;
    mean += (sample - mean) / frame;
    const double momentsWeight = std::max(1.0 / frame, noisy.inputs.momentsLeastWeight);
    first += (sample - first) * momentsWeight;
    second += (sample * sample - second) * momentsWeight;
    expected = frame <= framesToFloor ? mean : expected + noisy.inputs.leastWeight * (sample - expected);
    INFO("frame " << frame);
    REQUIRE(isSurface(outputs.guides, x, y));
    CHECK(outputs.historyLength.at(0, x, y) == float(frame));
    CHECK(outputs.irradiance.at(0, x, y) == Approx(expected).epsilon(1e-5));
    CHECK(outputs.moments.at(QUELL_MOMENT_FIRST, x, y) == Approx(first).epsilon(1e-5));
    CHECK(outputs.moments.at(QUELL_MOMENT_SECOND, x, y) == Approx(second).epsilon(1e-5));
  }
}

TEST_CASE("accumulate_noisy keeps a constant") {
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    CaseOptions options;
    options.size = {61, 40};
    options.mapping = mapping;
    AccumulateNoisyCase noisy(options, kPlain);
    std::fill(noisy.inputs.material.radiance.pixels.begin(), noisy.inputs.material.radiance.pixels.end(),
              3.25f);
    fill(noisy.inputs.irradiancePrev, 3.25f);
    noisy.upload();
    noisy.run();
    const auto outputs = noisy.outputs();
    forEachPixel(options.size, [&](int x, int y) {
      const double expected = isSurface(outputs.guides, x, y) ? 3.25 : 0.0;
      CHECK(outputs.irradiance.at(0, x, y) == Approx(expected).epsilon(kAccumulateNoisyTolerance));
    });
  }
}

TEST_CASE("accumulate_noisy rejects history that moved beyond the limits") {
  CaseOptions options;
  options.size = {61, 40};
  const auto acceptedTaps = [&](float shift, bool turnNormals) {
    AccumulateNoisyCase noisy(options, kPlain);
    standStill(noisy, 3.0f);
    forEachPixel(options.size, [&](int x, int y) {
      noisy.inputs.guidesPrev.at(QUELL_GUIDE_POSITION + 2, x, y) += shift;
      if (turnNormals) {
        for (int axis = 0; axis < 3; ++axis)
          noisy.inputs.guidesPrev.at(QUELL_GUIDE_NORMAL + axis, x, y) *= -1.0f;
      }
    });
    noisy.upload();
    noisy.run();
    std::size_t accepted = 0;
    for (const float mask : noisy.outputs().reprojectionMask.values) accepted += (int(mask) & 15) != 0;
    return accepted;
  };
  const ReprojectionParams params = makeReprojection({}, {}, options.size);
  const float fenceLimit = params.positionLimitFootprint * 4.0f;  // the nearest surface, the least limit
  const float wallLimit = params.positionLimitFootprint * 7.0f;   // beyond the farthest
  const std::size_t all = acceptedTaps(0.0f, false);
  CHECK(all > 1000);
  CHECK(acceptedTaps(0.9f * fenceLimit, false) == all);
  CHECK(acceptedTaps(1.1f * wallLimit, false) == 0);
  CHECK(acceptedTaps(0.0f, true) == 0);
}

TEST_CASE("accumulate_noisy keeps the history of a pixel without a sample") {
  CaseOptions options;
  options.size = {61, 40};
  AccumulateNoisyCase noisy(options, kPlain);
  standStill(noisy, 3.0f);
  for (float& value : noisy.inputs.material.radiance.pixels) value = std::numeric_limits<float>::quiet_NaN();
  noisy.upload();
  noisy.run();
  const auto outputs = noisy.outputs();
  forEachPixel(options.size, [&](int x, int y) {
    const bool surface = isSurface(outputs.guides, x, y);
    CHECK(outputs.historyLength.at(0, x, y) == (surface ? 3.0f : 0.0f));
    CHECK(outputs.irradiance.at(2, x, y) == (surface ? noisy.inputs.irradiancePrev.at(2, x, y) : 0.0f));
  });
}

TEST_CASE("accumulate_noisy without a sample has nothing new") {
  CaseOptions options;
  options.size = {61, 40};
  AccumulateNoisyCase noisy(options, kEverything);
  for (io::Image* image : {&noisy.inputs.material.radiance, &noisy.inputs.material.glossyRadiance})
    std::fill(image->pixels.begin(), image->pixels.end(), std::numeric_limits<float>::quiet_NaN());
  noisy.upload();
  noisy.run();
  const auto outputs = noisy.outputs();
  CHECK(sameBits(outputs.newestIrradiance, Planes(options.size, 6, -1.0f)));
  CHECK(sameBits(outputs.innovation, Planes(options.size, 2 * QUELL_INNOVATION_PLANES)));
}

TEST_CASE("accumulate_noisy takes materials that fade to black") {
  // Albedos from 1 down to the smallest denormal; in the next frame the pixels live on their faint history
  // alone.
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    CaseOptions options;
    options.size = {184, 31};
    options.mapping = mapping;
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
  for (const Mapping mapping : {Mapping::Wide, Mapping::Narrow}) {
    for (const AccumulateNoisyVariant& variant : {AccumulateNoisyVariant(), kEverything, kMotionAndObjects}) {
      CaseOptions options;
      options.size = {61, 40};
      options.mapping = mapping;
      AccumulateNoisyCase noisy(options, variant);
      noisy.upload();
      noisy.run();
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

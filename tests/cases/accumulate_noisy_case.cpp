#include "tests/cases/accumulate_noisy_case.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "host/core/frame_images.hpp"
#include "tests/support/random_images.hpp"
#include "tests/support/test_scene.hpp"

namespace quell::tests {
namespace {

// Of quell; not its defaults.
constexpr int kMostFrames = 7;
constexpr int kMostFramesStill = 12;

StageSetup makeAccumulateNoisySetup(const CaseOptions& options, const AccumulateNoisyVariant& variant) {
  StageSetup setup = makeSetup(options);
  if (variant.filterGuides) {
    setup.settings = Settings(variant.innovation ? "quell" : "svgf");
    setup.settings.set("momentsLeastWeight", 0.15);  // told apart from the weight of the irradiance
    if (variant.innovation) {
      setup.settings.set("historyFrames", kMostFrames);
      setup.settings.set("stillHistoryFrames", kMostFramesStill);
    } else {
      setup.settings.set("irradianceLeastWeight", 0.1);
    }
  }
  setFrameViews(setup, variant.images(), options.layout);
  ImageLayout layout = options.layout;
  layout.channels = std::max(2, layout.channels);
  if (variant.motion) setup.frame.motion = makeView(layout, setup.size);
  layout.channels = 1;
  if (layout.format == ComponentFormat::Float32) layout.format = ComponentFormat::UInt32;
  if (variant.objectId) setup.frame.objectId = makeView(layout, setup.size);
  return setup;
}

// The whole picture moves to the left half by one vector, to the right half pixel by pixel; some vectors lead out of
// the frame.
io::Image randomMotionVectors(Size size, unsigned seed) {
  Random random(seed);
  io::Image motion(size.width, size.height, 2);
  forEachPixel(size, [&](int x, int y) {
    const bool alike = x < size.width / 2;
    const double reach = random.uniform() < 0.1 ? 40.0 : 2.0;
    motion.at(x, y, 0) = alike ? 1.3f : float(random.uniform(-reach, reach));
    motion.at(x, y, 1) = alike ? -0.43f : float(random.uniform(-reach, reach));
  });
  return motion;
}

// Tiles of three objects, some pixels of others. Exact as halves.
float randomObject(Random& random, int x, int y) {
  return random.uniform() < 0.1 ? float(random.integer(0, 2000)) : float((x / 11 + y / 5) % 3);
}

// The bits of an id, as a number.
float wordOf(float id, ComponentFormat format) {
  return format == ComponentFormat::Float16 ? float(Eigen::half(id).x) : id;
}

// Returns the ids as the caller has them.
io::Image randomObjects(AccumulateNoisyInputs& inputs, Size size, unsigned seed, ComponentFormat format) {
  Random random(seed);
  io::Image ids(size.width, size.height, 1);
  inputs.objectId = ids;
  inputs.objectIdsPrev = Planes(size, 1);
  forEachPixel(size, [&](int x, int y) {
    ids.at(x, y, 0) = randomObject(random, x, y);
    inputs.objectId.at(x, y, 0) = wordOf(ids.at(x, y, 0), format);
    inputs.objectIdsPrev.at(0, x, y) = wordOf(randomObject(random, x, y), format);
  });
  return ids;
}

// Weights below 1 where the material fades out, 0 where a pixel could not be filtered; lengths up to the
// largest.
void randomLengths(AccumulateNoisyInputs& inputs, int signal, unsigned seed) {
  Random random(seed);
  forEachPixel(inputs.historyLengthPrev.size(), [&](int x, int y) {
    const double kind = random.uniform();
    float& weight = inputs.guidesPrev.at(QUELL_GUIDE_WEIGHT + signal, x, y);
    if (kind < 0.03) {
      weight = 0.0f;
    } else if (kind < 0.1) {
      weight *= float(random.uniform(0.001, 1.0));
    }
    const int longest = kind < 0.2 ? QUELL_MAX_HISTORY_LENGTH : 12;
    inputs.historyLengthPrev.at(signal, x, y) = weight > 0.0f ? float(random.integer(1, longest)) : 0.0f;
  });
}

void randomHistory(AccumulateNoisyInputs& inputs, Size size, unsigned seed) {
  const int signals = inputs.material.signals();
  inputs.irradiancePrev = randomPlanes(size, 3 * signals, seed + 1, 0.0, 8.0);
  inputs.momentsPrev = randomPlanes(size, QUELL_MOMENT_PLANES * signals, seed + 2, 0.0, 8.0);
  inputs.historyLengthPrev = Planes(size, signals);
  for (int signal = 0; signal < signals; ++signal)
    randomLengths(inputs, signal, seed + 10 * unsigned(signal));
}

void comparePixelPrev(Comparison& comparison, const Planes& device, const ExactPlanes& exact,
                      const BasicPlanes<char>& undecided) {
  forEachPixel(exact.size(), [&](int x, int y) {
    if (undecided.at(0, x, y)) return;
    for (int axis = 0; axis < 2; ++axis) {
      const double steps = device.at(axis, x, y) * QUELL_SUBPIXEL_STEPS;
      const double error = std::abs(device.at(axis, x, y) - exact.at(axis, x, y));
      comparison.include("pixelPrev in steps", axis, x, y, steps, std::floor(steps));
      // As a share of what is allowed, brought to the measure of the other outputs.
      const double share = error / kPixelPrevTolerance;
      comparison.include("pixelPrev error", axis, x, y, share <= 1.0 ? 0.0 : share, 0.0);
    }
  });
}

// A difference: relative to the larger of what it is taken of.
void compareInnovation(Comparison& comparison, const AccumulateNoisyOutputs<float>& device,
                       const AccumulateNoisyExact& exact, double unit) {
  for (int planeOfAll = 0; planeOfAll < device.innovation.count; ++planeOfAll) {
    const int signal = planeOfAll / QUELL_INNOVATION_PLANES;
    forEachPixel(device.innovation.size(), [&](int x, int y) {
      if (exact.undecided.at(0, x, y)) return;
      double scale = unit;
      for (int plane = 3 * signal; plane < 3 * signal + 3; ++plane)
        scale = std::max({scale, exact.outputs.newestIrradiance.at(plane, x, y),
                          exact.outputs.irradiance.at(plane, x, y)});
      comparison.include("innovation", planeOfAll, x, y, device.innovation.at(planeOfAll, x, y),
                         exact.outputs.innovation.at(planeOfAll, x, y), scale);
    });
  }
}

}  // namespace

AccumulateNoisyCase::AccumulateNoisyCase(const CaseOptions& options, const AccumulateNoisyVariant& variant)
    : StageCase("accumulate_noisy", makeAccumulateNoisySetup(options, variant)), m_variant(variant) {
  static_cast<FrameImages&>(inputs) = randomFrame(variant.images(), options);
  inputs.guidesPrev =
      renderScene(movedCamera(), options.size, inputs.material.signals(), options.holes()).guides;
  const Settings& settings = m_harness.configuration().settings;
  if (variant.innovation) {
    inputs.mostFrames = kMostFrames;
    inputs.mostFramesStill = kMostFramesStill;
    inputs.leastWeight = 1.0 / kMostFramesStill;
  } else {
    inputs.leastWeight =
        float(settings.get(variant.filterGuides ? "irradianceLeastWeight" : "noisyLeastWeight"));
  }
  inputs.momentsLeastWeight = variant.filterGuides ? float(settings.get("momentsLeastWeight")) : 0.0;
  randomHistory(inputs, options.size, options.seed + 20);
  if (variant.motion) inputs.motion = randomMotionVectors(options.size, options.seed + 40);
  if (variant.objectId)
    m_objectIds = randomObjects(inputs, options.size, options.seed + 50,
                                m_harness.configuration().frame.objectId.format);
  useReprojection(makeReprojection({}, movedCamera(), options.size));
}

void AccumulateNoisyCase::useReprojection(const ReprojectionParams& reprojection) {
  inputs.reprojection = reprojection;
  m_reprojection = reprojection;
}

void AccumulateNoisyCase::giveAllObjects(float id) {
  const float word = wordOf(id, m_harness.configuration().frame.objectId.format);
  std::fill(m_objectIds.pixels.begin(), m_objectIds.pixels.end(), id);
  std::fill(inputs.objectId.pixels.begin(), inputs.objectId.pixels.end(), word);
  std::fill(inputs.objectIdsPrev.values.begin(), inputs.objectIdsPrev.values.end(), word);
}

void AccumulateNoisyCase::upload() {
  uploadFrame(m_harness, inputs);
  uploadImage(m_harness, &Frame::motion, inputs.motion);
  if (m_variant.objectId) m_harness.setInput(&Frame::objectId, m_objectIds);
  m_harness.upload("irradiancePrev", inputs.irradiancePrev);
  m_harness.upload("historyLengthPrev", inputs.historyLengthPrev);
  m_harness.upload("guidesPrev", inputs.guidesPrev);
  if (m_variant.filterGuides) m_harness.upload("momentsPrev", inputs.momentsPrev);
  if (m_variant.objectId) m_harness.upload("objectIdsPrev", inputs.objectIdsPrev);
}

std::vector<LightInput> AccumulateNoisyCase::light() {
  std::vector<LightInput> all = lightOf(inputs.material);
  const std::vector<LightInput> moments = momentsOf(inputs.momentsPrev);
  all.push_back(lightOf(inputs.irradiancePrev));
  all.insert(all.end(), moments.begin(), moments.end());
  return all;
}

AccumulateNoisyOutputs<float> AccumulateNoisyCase::outputs() const {
  const auto downloadIf = [&](bool wanted, const char* name) {
    return wanted ? m_harness.download(name) : Planes();
  };
  return {m_harness.download("irradiance"),
          m_harness.download("historyLength"),
          m_harness.download("guides"),
          m_harness.download("pixelPrev"),
          m_harness.download("reprojectionMask"),
          downloadIf(m_variant.filterGuides, "moments"),
          downloadIf(m_variant.filterGuides, "viewDepth"),
          downloadIf(m_variant.filterGuides && m_variant.roughness, "roughness"),
          downloadIf(m_variant.objectId, "objectIds"),
          downloadIf(m_variant.innovation, "newestIrradiance"),
          downloadIf(m_variant.innovation, "innovation")};
}

Comparison AccumulateNoisyCase::compare() {
  Comparison comparison(leftOut());
  const AccumulateNoisyOutputs<float> device = outputs();
  const AccumulateNoisyExact exact = accumulateNoisyOracle(inputs, device.pixelPrev);
  comparison.exclude(exact.undecided);
  const auto* excluded = &exact.undecided;
  comparePixels(comparison, "irradiance", device.irradiance, exact.outputs.irradiance, excluded, nullptr,
                lightUnit());
  comparePixels(comparison, "historyLength", device.historyLength, exact.outputs.historyLength, excluded);
  comparePixels(comparison, "guides", device.guides, exact.outputs.guides, excluded);
  comparePixels(comparison, "reprojectionMask", device.reprojectionMask, exact.outputs.reprojectionMask,
                excluded);
  const auto compareIfPresent = [&](const char* name, const Planes& planes, const ExactPlanes& expected,
                                    double unit = 1.0) {
    if (planes.count > 0) comparePixels(comparison, name, planes, expected, excluded, nullptr, unit);
  };
  if (device.moments.count > 0) compareMoments(comparison, device.moments, exact.outputs.moments, excluded);
  compareIfPresent("viewDepth", device.viewDepth, exact.outputs.viewDepth);
  compareIfPresent("roughness", device.roughness, exact.outputs.roughness);
  compareIfPresent("objectIds", device.objectIds, exact.outputs.objectIds);
  compareIfPresent("newestIrradiance", device.newestIrradiance, exact.outputs.newestIrradiance, lightUnit());
  if (device.innovation.count > 0) compareInnovation(comparison, device, exact, lightUnit());
  // Where background was, antialiasing wants to know; elsewhere, that it lost no history.
  const bool antialiased = isJittered(m_harness.configuration().frame.camera);
  Comparison everywhere(antialiased ? nullptr : leftOut());
  if (leftOut() != nullptr && !antialiased)
    forEachPixel(size(), [&](int x, int y) {
      if (leftOut()->at(0, x, y))
        comparison.include("background mask", 0, x, y, device.reprojectionMask.at(0, x, y), 0.0);
    });
  comparePixels(everywhere, "first reprojectionMask", planesOf(device.reprojectionMask, 0, 1),
                planesOf(exact.outputs.reprojectionMask, 0, 1), excluded);
  comparePixelPrev(everywhere, device.pixelPrev, exact.outputs.pixelPrev, exact.undecided);
  comparison.include(everywhere);
  return comparison;
}

}  // namespace quell::tests

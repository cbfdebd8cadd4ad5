#include "host/methods/quell.hpp"

#include <algorithm>

#include "host/core/frame_images.hpp"
#include "host/methods/method_table.hpp"
#include "host/methods/quell_settings.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stages/atrous.hpp"
#include "host/stages/change_sums.hpp"
#include "host/stages/change_weight.hpp"
#include "host/stages/follow_change.hpp"
#include "host/stages/variance.hpp"

namespace quell {
namespace {

// Iterations from this one on take a cross of five taps instead of 3x3 (sweep, docs/quell-sweep.md).
constexpr int kFirstCross = 4;

// The irradiance that leaves iteration `i` (0: enters the first), and its variance.
struct Level {
  std::string irradiance;
  std::string variance;
};

Level levelAfter(int iteration) {
  if (iteration == 0) return {"irradiance", "variance"};
  return iteration % 2 == 1 ? Level{"filteredOdd", "varianceOdd"} : Level{"filteredEven", "varianceEven"};
}

int mostFramesStill(const QuellSettings& s) { return std::max(s.historyFrames, s.stillHistoryFrames); }

ChangeDetection changeDetection(const QuellSettings& s) {
  ChangeDetection detection;
  detection.leastWeight = 1.0 / mostFramesStill(s);
  detection.momentsLeastWeight = s.momentsLeastWeight;
  detection.mostWeight = s.mostWeight;
  detection.threshold = s.changeThreshold;
  detection.recentChangeThreshold = std::min(s.recentChangeThreshold, detection.threshold);
  detection.gain = s.changeGain;
  detection.sumsKept = s.changeMemory;
  return detection;
}

bool followsChange(const QuellSettings& s) { return s.mostWeight > 0.0; }

std::vector<BufferSpec> buffers(const Configuration& configuration, const QuellSettings& s) {
  const int signals = signalCount(configuration.frame);
  const std::size_t tiles = changeTileCount(configuration.size(), signals);
  const auto [columns, rows] = pixelItems(configuration);
  const auto f32 = Element::Float32;
  return {
      history("irradiance", f32, 3 * signals),
      history("historyLength", Element::UInt8, signals),
      history("guides", f32, QUELL_GUIDE_WEIGHT + signals),
      history("moments", f32, QUELL_MOMENT_PLANES * signals),
      transient("pixelPrev", f32, 2),
      transient("reprojectionMask", Element::UInt8, signals),
      transient("viewDepth", f32, 1),
      transient("roughness", f32, 1),
      transient("newestIrradiance", f32, 3 * signals),
      transient("innovation", f32, QUELL_INNOVATION_PLANES * signals),
      {"changeSums", f32, 0, tiles * QUELL_CHANGE_RECORD, followsChange(s)},
      {"recentChange", f32, 0, tiles, followsChange(s)},
      elements("changeWeights", tiles),
      transient("variance", f32, signals),
      {kSurfacesBuffer, Element::UInt8, 0, columns * rows, false},
      transient("filteredOdd", f32, 3 * signals),
      transient("varianceOdd", f32, signals),
      transient("filteredEven", f32, 3 * signals),
      transient("varianceEven", f32, signals),
  };
}

// What accumulate_noisy finds out for stages that leave out background.
std::vector<std::string> surfaceNames(const QuellSettings& s) {
  return s.skip ? std::vector<std::string>{kSurfacesBuffer} : std::vector<std::string>{};
}

void addAccumulation(Schedule& schedule, const Configuration& configuration, const QuellSettings& s) {
  const bool change = followsChange(s);
  const std::vector<std::string> accumulated = {"irradiance", "historyLength", "moments"};
  std::vector<std::string> writes = joinedNames(accumulated, {"pixelPrev", "reprojectionMask"});
  if (change) writes = joinedNames(writes, {"newestIrradiance", "innovation"});
  const std::vector<std::string> objectIds = addObjectIds(schedule, configuration);
  writes = joinedNames(joinedNames(writes, objectIds), surfaceNames(s));
  writes =
      joinedNames(joinedNames(writes, filterGuideNames(configuration)), addFBeta(schedule, configuration));
  AccumulateNoisy::Setup setup;
  setup.leastWeight = 1.0 / mostFramesStill(s);
  setup.momentsLeastWeight = s.momentsLeastWeight;
  setup.filterGuides = true;
  setup.mostFrames = s.historyFrames;
  setup.mostFramesStill = mostFramesStill(s);
  setup.skip = s.skip;
  setup.innovation = change;
  addStage(schedule, std::make_unique<AccumulateNoisy>(setup),
           joinedNames({"irradiance.prev", "historyLength.prev", "guides.prev", "moments.prev"},
                       previousNames(objectIds)),
           writes);
  if (!change) return;
  const ChangeDetection detection = changeDetection(s);
  addStage(schedule, std::make_unique<ChangeSums>(detection),
           {"innovation", "historyLength", "changeSums.prev"}, {"changeSums"});
  addStage(schedule, std::make_unique<ChangeWeight>(detection), {"changeSums", "recentChange.prev"},
           {"recentChange", "changeWeights"});
  addStage(schedule, std::make_unique<FollowChange>(detection, s.skip),
           joinedNames(joinedNames({"changeWeights", "newestIrradiance"}, accumulated), surfaceNames(s)),
           accumulated);
}

void addVariance(Schedule& schedule, const QuellSettings& s) {
  const bool skip = s.skip;
  addStage(schedule,
           std::make_unique<Variance>(Variance::Setup{s.stops, s.temporalVarianceFrames, skip, true}),
           joinedNames({"moments", "historyLength", "guides", "viewDepth"}, surfaceNames(s)), {"variance"});
}

void addFilter(Schedule& schedule, const Configuration& configuration, const QuellSettings& s) {
  std::vector<std::string> guides = filterGuideNames(configuration);
  Atrous::Setup setup;
  setup.stops = s.stops;
  setup.luminanceSigma = s.luminanceSigma;
  setup.sharpRoughness = s.sharpRoughness;
  setup.skip = s.skip;
  if (setup.skip) guides = joinedNames(guides, {kSurfacesBuffer});
  const int iterations = s.iterations;
  for (int i = 1; i <= iterations; ++i) {
    const Level in = levelAfter(i - 1);
    const Level out = levelAfter(i);
    setup.iteration = i;
    setup.step = 1 << (i - 1);
    // More taps where they are near lower the error of every scene; far ones are the fewer the better.
    setup.radius = i == 1 ? 2 : 1;
    setup.corners = i > 1 && i < kFirstCross;
    setup.input = in.irradiance;
    setup.output = out.irradiance;
    setup.variance = in.variance;
    std::vector<std::string> writes = {out.irradiance};
    if (i < iterations) {
      setup.varianceOut = out.variance;
      writes.push_back(out.variance);
    } else {
      setup.varianceOut.clear();  // nothing reads it
    }
    addStage(schedule, std::make_unique<Atrous>(setup), joinedNames({in.irradiance, in.variance}, guides),
             writes);
  }
}

Schedule makeSchedule(const Configuration& configuration, const QuellSettings& s) {
  Schedule schedule;
  schedule.buffers = buffers(configuration, s);
  addAccumulation(schedule, configuration, s);
  addVariance(schedule, s);
  addFilter(schedule, configuration, s);
  addOutputStages(schedule, configuration, levelAfter(s.iterations).irradiance, s.common.antialiasing,
                  s.skip);
  return schedule;
}

}  // namespace

Method quellMethod() {
  return makeMethod("quell", "history that follows changes of light, then a filter guided by its variance",
                    quellSettings(), makeSchedule);
}

}  // namespace quell

#include "host/methods/quell.hpp"

#include <algorithm>

#include "host/core/frame_images.hpp"
#include "host/methods/common_settings.hpp"
#include "host/methods/method_table.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stages/atrous.hpp"
#include "host/stages/change_sums.hpp"
#include "host/stages/change_weight.hpp"
#include "host/stages/follow_change.hpp"
#include "host/stages/variance.hpp"

namespace quell {
namespace {

using Kind = SettingKind;

// Iterations from this one on take a cross of five taps instead of 3x3 (sweep, docs/quell-sweep.md).
constexpr int kFirstCross = 4;

constexpr char kSweep[] = "sweep, docs/quell-sweep.md";

SettingList accumulationSettings() {
  return {{"historyFrames",
           Kind::Integer,
           5.0,
           1.0,
           255.0,
           "frames",
           "longest history of what moves on the screen",
           kSweep,
           {}},
          {"stillHistoryFrames",
           Kind::Integer,
           32.0,
           1.0,
           255.0,
           "frames",
           "longest history of what does not move on the screen; at least historyFrames counts",
           kSweep,
           {}},
          {"momentsLeastWeight",
           Kind::Real,
           0.2,
           0.001,
           1.0,
           "",
           "least weight of the newest sample in the moments of luminance",
           "Schied et al. 2017, section 4.2",
           {}},
          {"temporalVarianceFrames",
           Kind::Integer,
           3.0,
           1.0,
           255.0,
           "frames",
           "history length from which on the variance over time is trusted",
           kSweep,
           {}}};
}

SettingList skipSettings() {
  return {{"skip",
           Kind::Boolean,
           1.0,
           0.0,
           1.0,
           "",
           "leave out background, from accumulation to antialiasing",
           "ours, kernels/common/surfaces.h: a frame that is all sky takes a fifth of the time",
           {}}};
}

SettingList changeSettings() {
  return {{"mostWeight",
           Kind::Real,
           1.0,
           0.0,
           1.0,
           "",
           "largest weight of the newest sample, where the light changes; 0: change is not followed",
           kSweep,
           {}},
          {"changeThreshold",
           Kind::Real,
           3.0,
           0.0,
           100.0,
           "standard deviations",
           "difference between newest samples and history, over tiles, up to which it counts as noise",
           kSweep,
           {}},
          {"recentChangeThreshold",
           Kind::Real,
           1.0,
           0.0,
           100.0,
           "standard deviations",
           "the same where light has changed lately; at most changeThreshold counts",
           kSweep,
           {}},
          {"changeGain",
           Kind::Real,
           4.0,
           0.01,
           1e6,
           "variances",
           "excess of the squared difference over the threshold at which the weight is half of mostWeight",
           kSweep,
           {}},
          {"changeMemory",
           Kind::Real,
           0.4,
           0.0,
           0.99,
           "",
           "share of the frame before in the differences that are tested",
           kSweep,
           {}}};
}

SettingList filterSettings() {
  const SettingDescription luminanceSigma = {"luminanceSigma",
                                             Kind::Real,
                                             6.0,
                                             0.01,
                                             1e3,
                                             "standard deviations of the mean",
                                             "difference in luminance at which a tap's weight falls to 1/e",
                                             kSweep,
                                             {}};
  SettingList all = atrousSettings(luminanceSigma);
  for (SettingDescription& setting : all) setting.paper.reset();  // those are of another paper
  all.push_back(
      {"sharpRoughness",
       Kind::Real,
       0.3,
       0.0,
       1.0,
       "",
       "roughness below which luminanceSigma shrinks, to its half at roughness 0; 0, or no roughness image: "
       "nowhere",
       kSweep,
       {}});
  return all;
}

// The irradiance that leaves iteration `i` (0: enters the first), and its variance.
struct Level {
  std::string irradiance;
  std::string variance;
};

Level levelAfter(int iteration) {
  if (iteration == 0) return {"irradiance", "variance"};
  return iteration % 2 == 1 ? Level{"filteredOdd", "varianceOdd"} : Level{"filteredEven", "varianceEven"};
}

int mostFrames(const Settings& s) { return static_cast<int>(s.get("historyFrames")); }
int mostFramesStill(const Settings& s) {
  return std::max(mostFrames(s), static_cast<int>(s.get("stillHistoryFrames")));
}

ChangeDetection changeDetection(const Settings& s) {
  ChangeDetection detection;
  detection.leastWeight = 1.0 / mostFramesStill(s);
  detection.momentsLeastWeight = s.get("momentsLeastWeight");
  detection.mostWeight = s.get("mostWeight");
  detection.threshold = s.get("changeThreshold");
  detection.recentChangeThreshold = std::min(s.get("recentChangeThreshold"), detection.threshold);
  detection.gain = s.get("changeGain");
  detection.sumsKept = s.get("changeMemory");
  return detection;
}

bool followsChange(const Settings& s) { return s.get("mostWeight") > 0.0; }

std::vector<BufferSpec> buffers(const Configuration& configuration) {
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
      {"changeSums", f32, 0, tiles * QUELL_CHANGE_RECORD, followsChange(configuration.settings)},
      {"recentChange", f32, 0, tiles, followsChange(configuration.settings)},
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
std::vector<std::string> surfaceNames(const Settings& s) {
  return s.isOn("skip") ? std::vector<std::string>{kSurfacesBuffer} : std::vector<std::string>{};
}

void addAccumulation(Schedule& schedule, const Configuration& configuration) {
  const Settings& s = configuration.settings;
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
  setup.momentsLeastWeight = s.get("momentsLeastWeight");
  setup.filterGuides = true;
  setup.mostFrames = mostFrames(s);
  setup.mostFramesStill = mostFramesStill(s);
  setup.skip = s.isOn("skip");
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
  addStage(schedule, std::make_unique<FollowChange>(detection, s.isOn("skip")),
           joinedNames(joinedNames({"changeWeights", "newestIrradiance"}, accumulated), surfaceNames(s)),
           accumulated);
}

void addVariance(Schedule& schedule, const Settings& s) {
  const bool skip = s.isOn("skip");
  addStage(schedule,
           std::make_unique<Variance>(
               Variance::Setup{edgeStops(s), static_cast<int>(s.get("temporalVarianceFrames")), skip, true}),
           joinedNames({"moments", "historyLength", "guides", "viewDepth"}, surfaceNames(s)), {"variance"});
}

void addFilter(Schedule& schedule, const Configuration& configuration) {
  const Settings& s = configuration.settings;
  std::vector<std::string> guides = filterGuideNames(configuration);
  Atrous::Setup setup;
  setup.stops = edgeStops(s);
  setup.luminanceSigma = s.get("luminanceSigma");
  setup.sharpRoughness = s.get("sharpRoughness");
  setup.skip = s.isOn("skip");
  if (setup.skip) guides = joinedNames(guides, {kSurfacesBuffer});
  const int iterations = static_cast<int>(s.get("iterations"));
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

Schedule makeSchedule(const Configuration& configuration) {
  const Settings& s = configuration.settings;
  Schedule schedule;
  schedule.buffers = buffers(configuration);
  addAccumulation(schedule, configuration);
  addVariance(schedule, s);
  addFilter(schedule, configuration);
  addOutputStages(schedule, configuration, levelAfter(static_cast<int>(s.get("iterations"))).irradiance,
                  s.isOn("taa"), s.isOn("skip"));
  return schedule;
}

}  // namespace

Method quellMethod() {
  return {"quell", "history that follows changes of light, then a filter guided by its variance",
          joined({accumulationSettings(), changeSettings(), filterSettings(), skipSettings(),
                  demodulationSettings(), discardSettings(), antialiasingSettings()}),
          makeSchedule, discardLimits};
}

}  // namespace quell

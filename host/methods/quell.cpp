#include "host/methods/quell.hpp"

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

constexpr char kSweep[] = "sweep, docs/quell-sweep.md";

SettingList accumulationSettings() {
  return {{"irradianceLeastWeight",
           Kind::Real,
           0.2,
           0.001,
           1.0,
           "",
           "least weight of the newest sample, where the light does not change",
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

SettingList changeSettings() {
  return {{"mostWeight",
           Kind::Real,
           1.0,
           0.001,
           1.0,
           "",
           "largest weight of the newest sample, where the light changes; at most irradianceLeastWeight: "
           "change is "
           "not followed",
           kSweep,
           {}},
          {"changeThreshold",
           Kind::Real,
           2.0,
           0.0,
           100.0,
           "standard deviations",
           "difference between newest samples and history, over tiles, up to which it counts as noise",
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
           0.25,
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

ChangeDetection changeDetection(const Settings& s) {
  return {s.get("irradianceLeastWeight"), s.get("momentsLeastWeight"), s.get("mostWeight"),
          s.get("changeThreshold"),       s.get("changeGain"),         s.get("changeMemory")};
}

bool followsChange(const Settings& s) { return s.get("mostWeight") > s.get("irradianceLeastWeight"); }

std::vector<BufferSpec> buffers(const Configuration& configuration) {
  const int signals = signalCount(configuration.frame);
  const std::size_t tiles = changeTileCount(configuration.size(), signals);
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
      transient("innovation", f32, signals),
      {"changeSums", f32, 0, tiles * QUELL_CHANGE_RECORD, true},
      elements("changeWeights", tiles),
      transient("variance", f32, signals),
      transient("filteredOdd", f32, 3 * signals),
      transient("varianceOdd", f32, signals),
      transient("filteredEven", f32, 3 * signals),
      transient("varianceEven", f32, signals),
  };
}

void addAccumulation(Schedule& schedule, const Configuration& configuration) {
  const Settings& s = configuration.settings;
  const bool change = followsChange(s);
  const std::vector<std::string> accumulated = {"irradiance", "historyLength", "moments"};
  std::vector<std::string> writes = joinedNames(accumulated, {"pixelPrev", "reprojectionMask"});
  if (change) writes = joinedNames(writes, {"newestIrradiance", "innovation"});
  const std::vector<std::string> objectIds = addObjectIds(schedule, configuration);
  writes = joinedNames(writes, objectIds);
  writes =
      joinedNames(joinedNames(writes, filterGuideNames(configuration)), addFBeta(schedule, configuration));
  addStage(schedule,
           std::make_unique<AccumulateNoisy>(AccumulateNoisy::Setup{
               s.get("irradianceLeastWeight"), s.get("momentsLeastWeight"), "irradiance.prev", true, change}),
           joinedNames({"irradiance.prev", "historyLength.prev", "guides.prev", "moments.prev"},
                       previousNames(objectIds)),
           writes);
  if (!change) return;
  const ChangeDetection detection = changeDetection(s);
  addStage(schedule, std::make_unique<ChangeSums>(detection),
           {"innovation", "historyLength", "changeSums.prev"}, {"changeSums"});
  addStage(schedule, std::make_unique<ChangeWeight>(detection), {"changeSums"}, {"changeWeights"});
  addStage(schedule, std::make_unique<FollowChange>(detection),
           joinedNames({"changeWeights", "newestIrradiance"}, accumulated), accumulated);
}

void addFilter(Schedule& schedule, const Configuration& configuration) {
  const Settings& s = configuration.settings;
  const EdgeStops stops = edgeStops(s);
  const std::vector<std::string> filterGuides = filterGuideNames(configuration);
  addStage(schedule,
           std::make_unique<Variance>(Variance::Setup{
               stops, static_cast<int>(s.get("temporalVarianceFrames")), s.get("irradianceLeastWeight")}),
           {"moments", "historyLength", "guides", "viewDepth"}, {"variance"});
  for (int i = 1; i <= static_cast<int>(s.get("iterations")); ++i) {
    const Level in = levelAfter(i - 1);
    const Level out = levelAfter(i);
    // All taps where they are near: it lowers the error of every scene, more than in any later iteration.
    const int radius = i == 1 ? 2 : 1;
    addStage(schedule,
             std::make_unique<Atrous>(Atrous::Setup{stops, s.get("luminanceSigma"), 1 << (i - 1),
                                                    in.irradiance, out.irradiance, in.variance, out.variance,
                                                    radius, s.get("sharpRoughness")}),
             joinedNames({in.irradiance, in.variance}, filterGuides), {out.irradiance, out.variance});
  }
}

Schedule makeSchedule(const Configuration& configuration) {
  const Settings& s = configuration.settings;
  Schedule schedule;
  schedule.buffers = buffers(configuration);
  addAccumulation(schedule, configuration);
  addFilter(schedule, configuration);
  addOutputStages(schedule, configuration, levelAfter(static_cast<int>(s.get("iterations"))).irradiance,
                  s.isOn("taa"));
  return schedule;
}

}  // namespace

Method quellMethod() {
  return {"quell", "history that follows changes of light, then a filter guided by its variance",
          joined({accumulationSettings(), changeSettings(), filterSettings(), demodulationSettings(),
                  discardSettings(), antialiasingSettings()}),
          makeSchedule, discardLimits};
}

}  // namespace quell

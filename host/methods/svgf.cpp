#include "host/methods/svgf.hpp"

#include "host/core/frame_images.hpp"
#include "host/methods/common_settings.hpp"
#include "host/methods/method_table.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stages/atrous.hpp"
#include "host/stages/variance.hpp"

namespace quell {
namespace {

SettingList settings() {
  using Kind = SettingKind;
  const SettingDescription luminanceSigma = {
      "luminanceSigma",
      Kind::Real,
      3.5,
      0.01,
      1e3,
      "standard deviations",
      "difference in luminance at which a tap's weight falls to 1/e",
      "Schied et al. 2017, section 4.4; sweep over four rendered sequences, docs/svgf-sweep.md",
      {},
      "",
      4.0};
  const SettingList accumulation = {
      {"irradianceLeastWeight",
       Kind::Real,
       0.46,
       0.001,
       1.0,
       "",
       "least weight of the newest sample",
       "Schied et al. 2017, section 4.1; sweep over four rendered sequences, docs/svgf-sweep.md",
       {},
       "",
       0.2},
      {"momentsLeastWeight",
       Kind::Real,
       0.2,
       0.001,
       1.0,
       "",
       "least weight of the newest sample in the moments of luminance",
       "Schied et al. 2017, section 4.2",
       {},
       "",
       0.2},
      {"feedback",
       Kind::Choice,
       1.0,
       0.0,
       1.0,
       "",
       "what becomes the history: the first iteration's output or the unfiltered mean",
       "Schied et al. 2017, section 4.3 (first); sweep over four rendered sequences, docs/svgf-sweep.md",
       {"first", "none"},
       "",
       0.0},
      {"temporalVarianceFrames",
       Kind::Integer,
       4.0,
       1.0,
       255.0,
       "frames",
       "history length from which on the variance over time is trusted",
       "Schied et al. 2017, section 4.2",
       {},
       "",
       4.0}};
  return joined({accumulation, atrousSettings(luminanceSigma), demodulationSettings(), discardSettings(),
                 antialiasingSettings()});
}

// The irradiance that leaves iteration `i` (0: enters the first), and its variance.
struct Level {
  std::string irradiance;
  std::string variance;
};

Level levelAfter(int iteration, bool fedBack) {
  if (iteration == 0) return {"irradiance", "variance"};
  if (iteration == 1 && fedBack) return {"fedBack", "varianceOdd"};
  return iteration % 2 == 1 ? Level{"filteredOdd", "varianceOdd"} : Level{"filteredEven", "varianceEven"};
}

Schedule makeSchedule(const Configuration& configuration) {
  const Settings& s = configuration.settings;
  const int signals = signalCount(configuration.frame);
  const int iterations = static_cast<int>(s.get("iterations"));
  const bool fedBack = s.text("feedback") == "first";
  const EdgeStops stops = edgeStops(s);
  const std::string irradiancePrev = fedBack ? "fedBack.prev" : "irradiance.prev";
  const auto f32 = Element::Float32;

  Schedule schedule;
  schedule.buffers = {
      fedBack ? transient("irradiance", f32, 3 * signals) : history("irradiance", f32, 3 * signals),
      history("historyLength", Element::UInt8, signals),
      history("guides", f32, QUELL_GUIDE_WEIGHT + signals),
      history("moments", f32, QUELL_MOMENT_PLANES * signals),
      transient("pixelPrev", f32, 2),
      transient("reprojectionMask", Element::UInt8, signals),
      transient("viewDepth", f32, 1),
      transient("roughness", f32, 1),
      transient("variance", f32, signals),
      transient("filteredOdd", f32, 3 * signals),
      transient("varianceOdd", f32, signals),
      transient("filteredEven", f32, 3 * signals),
      transient("varianceEven", f32, signals),
  };
  if (fedBack) schedule.buffers.push_back(history("fedBack", f32, 3 * signals));

  const std::vector<std::string> filterGuides = filterGuideNames(configuration);
  const std::vector<std::string> objectIds = addObjectIds(schedule, configuration);
  addStage(
      schedule,
      std::make_unique<AccumulateNoisy>(AccumulateNoisy::Setup{
          s.get("irradianceLeastWeight"), s.get("momentsLeastWeight"), irradiancePrev, true}),
      joinedNames({irradiancePrev, "historyLength.prev", "guides.prev", "moments.prev"},
                  previousNames(objectIds)),
      joinedNames(
          joinedNames(joinedNames({"irradiance", "historyLength", "moments", "pixelPrev", "reprojectionMask"},
                                  objectIds),
                      filterGuides),
          addFBeta(schedule, configuration)));
  addStage(schedule,
           std::make_unique<Variance>(
               Variance::Setup{stops, static_cast<int>(s.get("temporalVarianceFrames")), false, false}),
           {"moments", "historyLength", "guides", "viewDepth"}, {"variance"});
  for (int i = 1; i <= iterations; ++i) {
    const Level in = levelAfter(i - 1, fedBack);
    const Level out = levelAfter(i, fedBack);
    addStage(
        schedule,
        std::make_unique<Atrous>(Atrous::Setup{stops, s.get("luminanceSigma"), 1 << (i - 1), in.irradiance,
                                               out.irradiance, in.variance, out.variance}),
        joinedNames({in.irradiance, in.variance}, filterGuides), {out.irradiance, out.variance});
  }
  addOutputStages(schedule, configuration, levelAfter(iterations, fedBack).irradiance, s.isOn("taa"));
  return schedule;
}

}  // namespace

Method svgfMethod() {
  return {"svgf", "Spatiotemporal Variance-Guided Filtering (Schied et al. 2017)", settings(), makeSchedule,
          discardLimits};
}

}  // namespace quell

#include "host/methods/atrous.hpp"

#include "host/core/frame_images.hpp"
#include "host/methods/common_settings.hpp"
#include "host/methods/method_table.hpp"
#include "host/stages/atrous.hpp"
#include "host/stages/demodulate.hpp"

namespace quell {
namespace {

SettingList settings() {
  const SettingDescription luminanceSigma = {
      "luminanceSigma",
      SettingKind::Real,
      4.0,
      0.01,
      1e6,
      "luminance",
      "difference in luminance at which a tap's weight falls to 1/e; halves with every iteration",
      "Dammertz et al. 2010, section 3 (halving); sweep over four rendered sequences, docs/svgf-sweep.md",
      {}};
  SettingList edgeStops = atrousSettings(luminanceSigma);
  for (SettingDescription& setting : edgeStops) setting.paper.reset();  // those are of another paper
  return joined({edgeStops, demodulationSettings()});
}

Schedule makeSchedule(const Configuration& configuration) {
  const Settings& s = configuration.settings;
  const int signals = signalCount(configuration.frame);
  const int iterations = static_cast<int>(s.get("iterations"));
  const auto f32 = Element::Float32;

  Schedule schedule;
  schedule.buffers = {
      transient("irradiance", f32, 3 * signals),
      transient("guides", f32, QUELL_GUIDE_WEIGHT + signals),
      transient("viewDepth", f32, 1),
      transient("roughness", f32, 1),
      transient("filteredOdd", f32, 3 * signals),
  };
  // Irradiance is not needed any more when the second iteration writes.
  const auto levelAfter = [](int i) { return std::string(i % 2 == 1 ? "filteredOdd" : "irradiance"); };

  const std::vector<std::string> filterGuides = filterGuideNames(configuration);
  addStage(schedule, std::make_unique<Demodulate>(), {},
           joinedNames(joinedNames({"irradiance"}, filterGuides), addFBeta(schedule, configuration)));
  for (int i = 1; i <= iterations; ++i) {
    const double sigma = s.get("luminanceSigma") / (1 << (i - 1));
    addStage(schedule,
             std::make_unique<Atrous>(
                 Atrous::Setup{edgeStops(s), sigma, 1 << (i - 1), levelAfter(i - 1), levelAfter(i), "", ""}),
             joinedNames({levelAfter(i - 1)}, filterGuides), {levelAfter(i)});
  }
  addOutputStages(schedule, configuration, levelAfter(iterations), false);
  return schedule;
}

}  // namespace

Method atrousMethod() {
  return {"atrous", "edge-avoiding a-trous wavelets, one frame alone (Dammertz et al. 2010)", settings(),
          makeSchedule, [](const Settings&) { return DiscardLimits{}; }};
}

}  // namespace quell

#include "host/methods/atrous.hpp"

#include "host/core/frame_images.hpp"
#include "host/methods/atrous_settings.hpp"
#include "host/methods/method_table.hpp"
#include "host/stages/atrous.hpp"
#include "host/stages/demodulate.hpp"

namespace quell {
namespace {

Schedule makeSchedule(const Configuration& configuration, const AtrousSettings& s) {
  const int signals = signalCount(configuration.frame);
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
  for (int i = 1; i <= s.iterations; ++i) {
    const double sigma = s.luminanceSigma / (1 << (i - 1));
    addStage(schedule,
             std::make_unique<Atrous>(
                 Atrous::Setup{s.stops, sigma, 1 << (i - 1), levelAfter(i - 1), levelAfter(i), "", ""}),
             joinedNames({levelAfter(i - 1)}, filterGuides), {levelAfter(i)});
  }
  addOutputStages(schedule, configuration, levelAfter(s.iterations), {});
  return schedule;
}

}  // namespace

Method atrousMethod() {
  return makeMethod("atrous", "edge-avoiding a-trous wavelets, one frame alone (Dammertz et al. 2010)",
                    atrousSettings(), makeSchedule);
}

}  // namespace quell

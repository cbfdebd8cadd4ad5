#include "host/methods/svgf.hpp"

#include "host/core/frame_images.hpp"
#include "host/methods/method_table.hpp"
#include "host/methods/svgf_settings.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stages/atrous.hpp"
#include "host/stages/variance.hpp"

namespace quell {
namespace {

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

Schedule makeSchedule(const Configuration& configuration, const SvgfSettings& s) {
  const int signals = signalCount(configuration.frame);
  const int iterations = s.iterations;
  const bool fedBack = s.feedback == Feedback::First;
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
      std::make_unique<AccumulateNoisy>(
          AccumulateNoisy::Setup{s.irradianceLeastWeight, s.momentsLeastWeight, irradiancePrev, true}),
      joinedNames({irradiancePrev, "historyLength.prev", "guides.prev", "moments.prev"},
                  previousNames(objectIds)),
      joinedNames(
          joinedNames(joinedNames({"irradiance", "historyLength", "moments", "pixelPrev", "reprojectionMask"},
                                  objectIds),
                      filterGuides),
          addFBeta(schedule, configuration)));
  addStage(schedule,
           std::make_unique<Variance>(Variance::Setup{s.stops, s.temporalVarianceFrames, false, false}),
           {"moments", "historyLength", "guides", "viewDepth"}, {"variance"});
  for (int i = 1; i <= iterations; ++i) {
    const Level in = levelAfter(i - 1, fedBack);
    const Level out = levelAfter(i, fedBack);
    addStage(schedule,
             std::make_unique<Atrous>(Atrous::Setup{s.stops, s.luminanceSigma, 1 << (i - 1), in.irradiance,
                                                    out.irradiance, in.variance, out.variance}),
             joinedNames({in.irradiance, in.variance}, filterGuides), {out.irradiance, out.variance});
  }
  addOutputStages(schedule, configuration, levelAfter(iterations, fedBack).irradiance, s.common.antialiasing);
  return schedule;
}

}  // namespace

Method svgfMethod() {
  return makeMethod("svgf", "Spatiotemporal Variance-Guided Filtering (Schied et al. 2017)", svgfSettings(),
                    makeSchedule);
}

}  // namespace quell

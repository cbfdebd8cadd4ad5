// svgf: Spatiotemporal Variance-Guided Filtering, Schied et al. 2017.
#include "host/methods/method.hpp"
#include "host/methods/method_table.hpp"
#include "host/methods/svgf_settings.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stages/atrous.hpp"
#include "host/stages/variance.hpp"

namespace quell {
namespace {

Schedule makeSchedule(const Configuration& configuration, const SvgfSettings& s) {
  const bool fedBack = s.feedback == Feedback::First;
  const bool skip = s.common.skip;
  const auto level = [&](int iteration) {
    FilterLevel after = levelAfter(iteration);
    if (fedBack && iteration == 1) after.irradiance = "fedBack";
    return after;
  };

  Schedule table;
  AccumulateNoisy::Setup accumulation;
  accumulation.leastWeight = s.irradianceLeastWeight;
  accumulation.momentsLeastWeight = s.momentsLeastWeight;
  accumulation.filterGuides = true;
  accumulation.skip = skip;
  accumulation.antialiasBackground = antialiases(configuration, s.common.antialiasing);
  add(table, AccumulateNoisy(configuration, accumulation),
      {{"irradiancePrev", fedBack ? level(1).irradiance : "irradiance"}});
  Variance::Setup variance{s.stops, s.temporalVarianceFrames, skip};
  variance.fireflyRatio = s.fireflyRatio;
  variance.momentsLeastWeight = s.momentsLeastWeight;
  variance.stopLuminance = s.keepLight;
  add(table, Variance(configuration, variance));
  Atrous::Setup filter;
  filter.stops = s.stops;
  filter.luminanceSigma = s.luminanceSigma;
  filter.variance = true;
  filter.skip = skip;
  for (int i = 1; i <= s.iterations; ++i) {
    filter.iteration = i;
    filter.tapWeights = i == 1 && s.fireflyRatio > 0.0;
    filter.filterVariance = i < s.iterations;  // nothing reads that of the last
    add(table, Atrous(configuration, filter), atrousWires(level(i - 1), level(i)));
  }
  const std::string filtered = level(s.iterations).irradiance;
  if (s.keepLight) addLightGain(table, configuration, filtered);
  addOutputStages(table, configuration, filtered, s.common.antialiasing, skip, BackgroundAntialiasing::Always,
                  s.keepLight);
  return table;
}

}  // namespace

Method svgfMethod() {
  return makeMethod("svgf", "Spatiotemporal Variance-Guided Filtering (Schied et al. 2017)", svgfSettings(),
                    makeSchedule);
}

}  // namespace quell

// quell: history that follows changes of light, then a filter guided by its variance.
#include <algorithm>
#include <string>

#include "host/methods/method.hpp"
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

void addAccumulation(Schedule& table, const Configuration& configuration, const QuellSettings& s) {
  const bool followsChange = s.mostWeight > 0.0;
  AccumulateNoisy::Setup setup;
  setup.leastWeight = 1.0 / mostFramesStill(s);
  setup.momentsLeastWeight = s.momentsLeastWeight;
  setup.filterGuides = true;
  setup.mostFrames = s.historyFrames;
  setup.mostFramesStill = mostFramesStill(s);
  setup.skip = s.common.skip;
  setup.innovation = followsChange;
  setup.antialiasBackground = s.common.antialiasing.jitteredRays;
  add(table, AccumulateNoisy(configuration, setup));
  if (!followsChange) return;
  const ChangeDetection detection = changeDetection(s);
  add(table, ChangeSums(configuration, detection));
  add(table, ChangeWeight(configuration, detection));
  add(table, FollowChange(configuration, detection, s.common.skip));
}

void addFilter(Schedule& table, const Configuration& configuration, const QuellSettings& s) {
  Atrous::Setup setup;
  setup.stops = s.stops;
  setup.sharpRoughness = s.sharpRoughness;
  setup.variance = true;
  setup.skip = s.common.skip;
  for (int i = 1; i <= s.iterations; ++i) {
    setup.iteration = i;
    setup.tapWeights = i == 1 && s.fireflyRatio > 0.0;
    setup.stopLuminance = i <= s.prefilteredIterations;
    setup.luminanceSigma = setup.stopLuminance ? s.prefilteredSigma : s.luminanceSigma;
    setup.filterVariance = i < s.iterations;  // nothing reads that of the last
    // More taps where they are near lower the error of every scene; far ones are the fewer the better.
    setup.radius = i == 1 ? 2 : 1;
    setup.corners = i > 1 && i < kFirstCross;
    add(table, Atrous(configuration, setup), atrousWires(levelAfter(i - 1), levelAfter(i)));
  }
}

void addVariance(Schedule& table, const Configuration& configuration, const QuellSettings& s) {
  Variance::Setup variance{s.stops, s.temporalVarianceFrames, s.common.skip};
  variance.ofMean = true;
  variance.fireflyRatio = s.fireflyRatio;
  variance.momentsLeastWeight = s.momentsLeastWeight;
  variance.stopLuminance = s.prefilteredIterations > 0 || s.keepLight;
  add(table, Variance(configuration, variance));
}

Schedule makeSchedule(const Configuration& configuration, const QuellSettings& s) {
  Schedule table;
  addAccumulation(table, configuration, s);
  const bool filters = s.iterations > 0, keepsLight = filters && s.keepLight;
  const std::string filtered = levelAfter(s.iterations).irradiance;
  if (filters) {
    addVariance(table, configuration, s);
    addFilter(table, configuration, s);
  }
  if (keepsLight) addLightGain(table, configuration, filtered);
  addOutputStages(table, configuration, filtered, s.common.antialiasing, s.common.skip,
                  BackgroundAntialiasing::IfJittered, keepsLight);
  return table;
}

}  // namespace

Method quellMethod() {
  return makeMethod("quell", "history that follows changes of light, then a filter guided by its variance",
                    quellSettings(), makeSchedule);
}

}  // namespace quell

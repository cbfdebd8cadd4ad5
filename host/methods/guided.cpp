// guided: guided image filter, He et al. 2013, guided by normals and depth as in Bauszat et al. 2011, over a history, as
// Koskela et al. 2019, section 6.2, compare with it: albedo is divided out and noisy samples are accumulated.
// Departures: depth counts relative to that of the window (kernels/guided_solve.cl); one radius for all light instead of one
// for direct and one for indirect; fireflies have less weight (fireflyRatio).
#include <algorithm>

#include "host/core/frame_images.hpp"
#include "host/methods/guided_settings.hpp"
#include "host/methods/method.hpp"
#include "host/methods/method_table.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stages/firefly_weights.hpp"
#include "host/stages/guided_evaluate.hpp"
#include "host/stages/guided_moments.hpp"
#include "host/stages/guided_solve.hpp"

namespace quell {
namespace {

Schedule makeSchedule(const Configuration& configuration, const GuidedSettings& s) {
  const bool skip = s.common.skip, tapWeights = s.fireflyRatio > 0.0;
  Schedule table;
  AccumulateNoisy::Setup accumulation;
  accumulation.leastWeight = s.irradianceLeastWeight;
  accumulation.filterGuides = true;
  accumulation.skip = skip;
  accumulation.antialiasBackground = antialiases(configuration, s.common.antialiasing);
  add(table, AccumulateNoisy(configuration, accumulation));
  if (tapWeights) add(table, FireflyWeights(configuration, s.fireflyRatio, skip));

  const int signals = signalCount(configuration.frame);
  BoxFilter::Setup windows;
  windows.grid = guidedCells(configuration.size(), s.subsampling);
  const int radius = std::max(1, (s.radius + s.subsampling / 2) / s.subsampling);
  add(table, GuidedMoments(configuration, s.subsampling, tapWeights, skip));
  windows.what = "moments";
  windows.planes = QUELL_GUIDED_SUMS * signals;
  addWindows(table, windows, {radius, radius}, "moments", "windowMoments");
  add(table, GuidedSolve(configuration, s.subsampling, s.epsilon));
  windows.what = "coefficients";
  windows.planes = QUELL_GUIDED_COEFFICIENTS * signals;
  addWindows(table, windows, {radius, radius}, "coefficients", "windowCoefficients");
  add(table, GuidedEvaluate(configuration, s.subsampling, skip));
  addOutputStages(table, configuration, "guidedIrradiance", s.common.antialiasing, skip,
                  BackgroundAntialiasing::Always);
  return table;
}

}  // namespace

Method guidedMethod() {
  return makeMethod("guided", "guided image filter over a history (He et al. 2013, Bauszat et al. 2011)",
                    guidedSettings(), makeSchedule);
}

}  // namespace quell

// edagi: An Efficient Denoising Algorithm for Global Illumination, Mara et al. 2017.
// Its matte light is the first signal, its glossy light the second; with one signal all light is matte. Noise-free direct
// light, which the paper leaves unfiltered, belongs into the emission image.
// Departures: light is divided by albedo and gloss colour, or by F_beta with `demodulate=fbeta`, instead of the Fresnel terms
// of eq. (1) at the mirror direction; and see the comments of the stages.
#include <quell/error.hpp>
#include <string>

#include "host/core/frame_images.hpp"
#include "host/core/number_text.hpp"
#include "host/methods/edagi_settings.hpp"
#include "host/methods/method.hpp"
#include "host/methods/method_table.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stages/confidence_cells.hpp"
#include "host/stages/low_confidence.hpp"
#include "host/stages/median_filter.hpp"
#include "host/stages/separable_bilateral.hpp"
#include "host/stages/soft_history.hpp"
#include "host/stages/sparse_bilateral.hpp"
#include "host/stages/virtual_motion.hpp"

namespace quell {
namespace {

constexpr int kMatte = 0, kGlossy = 1;

SoftHistory::Setup historySetup(const EdagiSettings& settings, int signal) {
  const EdagiHistory& s = settings.history;
  if (!(s.farFootprints + s.farDistance > s.nearFootprints + s.nearDistance))
    throw Error(ErrorCode::InvalidArgument,
                {"settings", "farFootprints and farDistance", "more than nearFootprints and nearDistance",
                 numberText(s.farFootprints) + " and " + numberText(s.farDistance)});
  SoftHistory::Setup setup;
  setup.signal = signal;
  setup.hysteresis = s.hysteresis;
  setup.meanFirst = s.meanFirst;
  setup.nearFootprints = s.nearFootprints;
  setup.farFootprints = s.farFootprints;
  setup.nearDistance = s.nearDistance;
  setup.farDistance = s.farDistance;
  setup.clampSigma = s.clampSigma;
  setup.skip = settings.common.skip;
  return setup;
}

// Stage 3 or 8; `history`: the buffer that was left for this frame.
void addHistory(Schedule& table, const Configuration& configuration, const EdagiSettings& s, int signal,
                bool virtualPositions, const std::string& history) {
  SoftHistory::Setup setup = historySetup(s, signal);
  setup.virtualPositions = virtualPositions;
  const std::string positions = virtualPositions ? "virtualPositions" : "guides";
  add(table, SoftHistory(configuration, setup),
      {{"positions", positions},
       {"positionsPrev", positions},
       {"tapMask", virtualPositions ? "virtualMask" : "reprojectionMask"},
       {"pixelPrev", virtualPositions ? "virtualPixelPrev" : "pixelPrev"},
       {"historyPrev", history}});
}

// The newest samples alone, and where their surfaces were.
void addSamples(Schedule& table, const Configuration& configuration, const EdagiSettings& s) {
  AccumulateNoisy::Setup setup;
  setup.leastWeight = 1.0;
  setup.filterGuides = true;
  setup.skip = s.common.skip;
  setup.antialiasBackground = antialiases(configuration, s.common.antialiasing);
  add(table, AccumulateNoisy(configuration, setup));
}

// Stage 5: the least confidence of cells, and in windows of them that the last filter's disc reaches.
void addLowConfidence(Schedule& table, const Configuration& configuration, const EdagiSettings& s) {
  add(table, LowConfidence(configuration));
  const double radius = s.radiusShare * configuration.size().width;
  BoxFilter::Setup cells;
  cells.grid = confidenceCells(configuration.size());
  cells.minima = true;
  cells.what = "confidence";
  const auto reach = [&](int pixels) { return static_cast<int>(radius / pixels + 0.5); };
  addWindows(table, cells, {reach(QUELL_CONFIDENCE_CELL_WIDTH), reach(QUELL_CONFIDENCE_CELL_HEIGHT)},
             "cellConfidence", "windowConfidence");
}

// Stages 3 to 7.
void addMatte(Schedule& table, const Configuration& configuration, const EdagiSettings& s) {
  const bool skip = s.common.skip;
  addHistory(table, configuration, s, kMatte, false, "history");
  SparseBilateral::Setup disc;
  disc.stops = s.stops;
  disc.radiusShare = s.historyRadiusShare;
  disc.skip = skip;
  add(table, SparseBilateral(configuration, disc), {{"sparseInput", "blended"}, {"sparseOutput", "history"}});
  addLowConfidence(table, configuration, s);
  if (s.suppressFireflies)
    add(table, MedianFilter(configuration, skip), {{"medianInput", "blended"}, {"medianOutput", "shown"}});
  disc.radiusShare = s.radiusShare;
  disc.followsConfidence = true;
  disc.lowFactor = s.lowConfidenceFactor;
  add(table, SparseBilateral(configuration, disc),
      {{"sparseInput", s.suppressFireflies ? "shown" : "blended"}, {"sparseOutput", "filtered"}});
}

// Stages 8 to 10.
void addGlossy(Schedule& table, const Configuration& configuration, const EdagiSettings& s) {
  const bool hits = configuration.frame.hitDistance.present();
  if (hits) add(table, VirtualMotion(configuration, s.common.skip));
  addHistory(table, configuration, s, kGlossy, hits, "blended");
  SeparableBilateral::Setup pass;
  pass.stops = s.stops;
  pass.signal = kGlossy;
  pass.sigma = s.glossySigma;
  pass.skip = s.common.skip;
  add(table, SeparableBilateral(configuration, pass),
      {{"separableInput", "blended"}, {"separableOutput", "glossyColumns"}});
  pass.alongRows = true;
  add(table, SeparableBilateral(configuration, pass),
      {{"separableInput", "glossyColumns"}, {"separableOutput", "filtered"}});
}

Schedule makeSchedule(const Configuration& configuration, const EdagiSettings& s) {
  Schedule table;
  addSamples(table, configuration, s);
  addMatte(table, configuration, s);
  if (signalCount(configuration.frame) > 1) addGlossy(table, configuration, s);
  addOutputStages(table, configuration, "filtered", s.common.antialiasing, s.common.skip,
                  BackgroundAntialiasing::Always);
  return table;
}

}  // namespace

Method edagiMethod() {
  return makeMethod("edagi", "An Efficient Denoising Algorithm for Global Illumination (Mara et al. 2017)",
                    edagiSettings(), makeSchedule);
}

}  // namespace quell

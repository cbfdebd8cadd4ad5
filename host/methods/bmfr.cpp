// bmfr: Blockwise Multi-Order Feature Regression, Koskela et al. 2019.
#include <quell/error.hpp>

#include "host/core/frame_images.hpp"
#include "host/methods/bmfr_settings.hpp"
#include "host/methods/method.hpp"
#include "host/methods/method_table.hpp"
#include "host/stages/accumulate_filtered.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stages/blended_sum.hpp"
#include "host/stages/firefly_weights.hpp"
#include "host/stages/fit.hpp"
#include "host/stages/gram_solve.hpp"
#include "host/stages/gram_sums.hpp"
#include "host/stages/material_guides.hpp"
#include "host/stages/weighted_sum.hpp"

namespace quell {
namespace {

GramWindows makeWindows(const BmfrSettings& s) {
  if (s.windows == Windows::Blocks) return {};
  if (s.solver != Solver::Gram)
    throw Error(ErrorCode::InvalidArgument,
                {"settings", "windows", "blocks with the householder solver", choiceName(s.windows)});
  return {true, s.tileSize};
}

void requireImages(const FitFeatures& features, const Frame& frame) {
  const auto require = [&](bool needed, const char* image, const ImageView& view) {
    if (!needed || view.present()) return;
    throw Error(ErrorCode::InvalidArgument,
                {"prepare", image, std::string("an image, since a feature is made of it"), "none"});
  };
  require(features.needAlbedo(), "albedo", frame.albedo);
  require(features.needRoughness(), "roughness", frame.roughness);
}

// Fits one signal and evaluates the fit.
void addFit(Schedule& table, const Configuration& configuration, const BmfrSettings& s, int signal) {
  const GramWindows windows = makeWindows(s);
  const FitFeatures& features = s.features;
  const bool skip = s.common.skip, tapWeights = s.fireflyRatio > 0.0;
  if (s.solver == Solver::Gram) {
    add(table, GramSums(configuration, windows, features, signal, tapWeights, skip));
    add(table, GramSolve(configuration, windows, s.noiseAmplitude, features));
  } else {
    add(table, Fit(configuration, features, {s.noiseAmplitude, s.featureStorage, signal, tapWeights, skip}));
  }
  if (windows.overlap) {
    add(table, BlendedSum(configuration, windows, features, signal, skip));
  } else {
    add(table, WeightedSum(configuration, features, signal, skip));
  }
}

Schedule makeSchedule(const Configuration& configuration, const BmfrSettings& s) {
  requireImages(s.features, configuration.frame);
  Schedule table;
  AccumulateNoisy::Setup accumulation;
  accumulation.leastWeight = s.noisyLeastWeight;
  accumulation.skip = s.common.skip;
  accumulation.antialiasBackground = antialiases(configuration, s.common.antialiasing);
  accumulation.filterGuides = accumulation.antialiasBackground;  // antialiasing looks at depths
  add(table, AccumulateNoisy(configuration, accumulation));
  if (s.fireflyRatio > 0.0) add(table, FireflyWeights(configuration, s.fireflyRatio, s.common.skip));
  if (s.features.needMaterial()) add(table, MaterialGuides(s.features));
  for (int signal = 0; signal < signalCount(configuration.frame); ++signal)
    addFit(table, configuration, s, signal);
  add(table, AccumulateFiltered(configuration, s.filteredLeastWeight, s.common.skip));
  addOutputStages(table, configuration, "filtered", s.common.antialiasing, s.common.skip,
                  BackgroundAntialiasing::Always);
  return table;
}

}  // namespace

Method bmfrMethod() {
  return makeMethod("bmfr", "Blockwise Multi-Order Feature Regression (Koskela et al. 2019)", bmfrSettings(),
                    makeSchedule);
}

}  // namespace quell

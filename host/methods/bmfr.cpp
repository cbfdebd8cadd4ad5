#include "host/methods/bmfr.hpp"

#include <quell/error.hpp>

#include "host/core/frame_images.hpp"
#include "host/methods/bmfr_settings.hpp"
#include "host/methods/method_table.hpp"
#include "host/stages/accumulate_filtered.hpp"
#include "host/stages/accumulate_noisy.hpp"
#include "host/stages/blended_sum.hpp"
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

Schedule makeSchedule(const Configuration& configuration, const BmfrSettings& s) {
  const int signals = signalCount(configuration.frame);
  const bool gram = s.solver == Solver::Gram;
  const GramWindows windows = makeWindows(s);
  const FitFeatures& features = s.features;
  requireImages(features, configuration.frame);
  const Size size = configuration.size();

  Schedule schedule;
  schedule.buffers = {
      history("irradiance", Element::Float32, 3 * signals),
      history("historyLength", Element::UInt8, signals),
      history("guides", Element::Float32, QUELL_GUIDE_WEIGHT + signals),
      history("filtered", Element::Float32, 3 * signals),
      transient("pixelPrev", Element::Float32, 2),
      transient("reprojectionMask", Element::UInt8, signals),
      transient("materials", Element::Float32, QUELL_MATERIAL_PLANES),
      transient("fitted", Element::Float32, 3 * signals),
      elements("fitRecords",
               gram ? gramRecordElements(windows, size, features) : Fit::recordElements(size, features)),
      elements("gramTiles", gramTileElements(windows, size, features)),
      elements("fitStorage", Fit::storageElements(size, s.featureStorage, features)),
  };

  const auto add = [&](std::unique_ptr<Stage> stage, std::vector<std::string> reads,
                       std::vector<std::string> writes) {
    addStage(schedule, std::move(stage), std::move(reads), std::move(writes));
  };
  const std::vector<std::string> objectIds = addObjectIds(schedule, configuration);
  // clang-format off
  add(std::make_unique<AccumulateNoisy>(AccumulateNoisy::Setup{s.noisyLeastWeight}),
      joinedNames({"irradiance.prev", "historyLength.prev", "guides.prev"}, previousNames(objectIds)),
      joinedNames(joinedNames({"irradiance", "historyLength", "guides", "pixelPrev", "reprojectionMask"},
                              objectIds),
                  addFBeta(schedule, configuration)));
  std::vector<std::string> guides = {"guides"};
  if (features.needMaterial()) {
    add(std::make_unique<MaterialGuides>(features),
        {},
        {"materials"});
    guides.push_back("materials");
  }
  for (int signal = 0; signal < signals; ++signal) {
    if (gram) {
      add(std::make_unique<GramSums>(windows, features, signal),
          joinedNames({"irradiance"}, guides),
          {"gramTiles"});
      add(std::make_unique<GramSolve>(windows, s.noiseAmplitude, features),
          {"gramTiles"},
          {"fitRecords"});
    } else {
      add(std::make_unique<Fit>(s.noiseAmplitude, s.featureStorage, features, signal),
          joinedNames({"irradiance"}, guides),
          {"fitRecords", "fitStorage"});
    }
    if (windows.overlap) {
      add(std::make_unique<BlendedSum>(windows, features, signal),
          joinedNames({"fitRecords"}, guides),
          {"fitted"});
    } else {
      add(std::make_unique<WeightedSum>(features, signal),
          joinedNames({"fitRecords"}, guides),
          {"fitted"});
    }
  }
  add(std::make_unique<AccumulateFiltered>(s.filteredLeastWeight),
      {"fitted", "filtered.prev", "pixelPrev", "reprojectionMask", "historyLength"},
      {"filtered"});
  // clang-format on
  addOutputStages(schedule, configuration, "filtered", s.common.antialiasing);
  return schedule;
}

}  // namespace

Method bmfrMethod() {
  return makeMethod("bmfr", "Blockwise Multi-Order Feature Regression (Koskela et al. 2019)", bmfrSettings(),
                    makeSchedule);
}

}  // namespace quell

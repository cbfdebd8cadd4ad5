#include "host/methods/bmfr.hpp"

#include <quell/error.hpp>

#include "host/core/frame_images.hpp"
#include "host/methods/common_settings.hpp"
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

SettingList settings() {
  using Kind = SettingKind;
  const SettingList fit = {
      {"noisyLeastWeight",
       Kind::Real,
       0.2,
       0.001,
       1.0,
       "",
       "least weight of the newest noisy sample",
       "Koskela et al. 2019, phase I",
       {}},
      {"filteredLeastWeight",
       Kind::Real,
       0.1,
       0.001,
       1.0,
       "",
       "least weight of the newest filtered frame",
       "Koskela et al. 2019, phase III",
       {}},
      {"features",
       Kind::Text,
       0.0,
       0.0,
       0.0,
       "",
       "features of the fit, separated by commas: the constant 1 (implied), normal n (or nx, ny, nz), "
       "position w, depth, "
       "gradients g, albedo, roughness; squares w2, cubes w3, sqrt(w), products wx*ny, differences wx-wy; at "
       "most 16 scalars",
       "Koskela et al. 2019, section on feature buffers; Flatval 2020, table 5.3",
       {},
       kDefaultFeatures},
      {"noiseAmplitude",
       Kind::Real,
       0.01,
       0.0,
       1.0,
       "scaled feature units",
       "amplitude of the stochastic regularisation",
       "Koskela et al. 2019, phase II",
       {}},
      {"solver",
       Kind::Choice,
       0.0,
       0.0,
       1.0,
       "",
       "how the least-squares problem is solved: QR of the pixels, or normal equations from sums over tiles",
       "Koskela et al. 2019, phase II (householder)",
       {"householder", "gram"}},
      {"windows",
       Kind::Choice,
       0.0,
       0.0,
       1.0,
       "",
       "what is fitted: displaced 32x32 blocks, or overlapping windows of 3x3 tiles, blended (gram only)",
       "Koskela et al. 2019, phase II (blocks)",
       {"blocks", "overlap"}},
      {"tileSize",
       Kind::Choice,
       0.0,
       0.0,
       1.0,
       "pixels",
       "edge of a tile (overlapping windows only)",
       "16 has a higher error at 480x270",
       {"8", "16"}},
      {"featureStorage",
       Kind::Choice,
       0.0,
       0.0,
       1.0,
       "",
       "format of the matrix while a block is factorised (householder only)",
       "Koskela et al. 2019, reference implementation (half)",
       {"float", "half"}},
  };
  return joined({fit, demodulationSettings(), discardSettings(), antialiasingSettings()});
}

GramWindows makeWindows(const Settings& s) {
  GramWindows windows;
  windows.overlap = s.text("windows") == "overlap";
  if (windows.overlap) windows.tileEdge = std::stoi(s.text("tileSize"));
  if (windows.overlap && s.text("solver") != "gram") {
    throw Error(ErrorCode::InvalidArgument,
                {"settings", "windows", "blocks with the householder solver", s.text("windows")});
  }
  return windows;
}

FitFeatures makeFeatures(const Configuration& configuration) {
  const FitFeatures features(configuration.settings.text("features"));
  const auto require = [&](bool needed, const char* image, const ImageView& view) {
    if (!needed || view.present()) return;
    throw Error(ErrorCode::InvalidArgument,
                {"prepare", image, std::string("an image, since a feature is made of it"), "none"});
  };
  require(features.needAlbedo(), "albedo", configuration.frame.albedo);
  require(features.needRoughness(), "roughness", configuration.frame.roughness);
  return features;
}

void checkText(const std::string& setting, const std::string& text) {
  if (setting == "features") FitFeatures{text};
}

Schedule makeSchedule(const Configuration& configuration) {
  const Settings& s = configuration.settings;
  const int signals = signalCount(configuration.frame);
  const auto storage = static_cast<FeatureStorage>(static_cast<int>(s.get("featureStorage")));
  const bool gram = s.text("solver") == "gram";
  const GramWindows windows = makeWindows(s);
  const FitFeatures features = makeFeatures(configuration);
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
      elements("fitStorage", Fit::storageElements(size, storage, features)),
  };

  const auto add = [&](std::unique_ptr<Stage> stage, std::vector<std::string> reads,
                       std::vector<std::string> writes) {
    addStage(schedule, std::move(stage), std::move(reads), std::move(writes));
  };
  const std::vector<std::string> objectIds = addObjectIds(schedule, configuration);
  // clang-format off
  add(std::make_unique<AccumulateNoisy>(AccumulateNoisy::Setup{s.get("noisyLeastWeight")}),
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
      add(std::make_unique<GramSolve>(windows, s.get("noiseAmplitude"), features),
          {"gramTiles"},
          {"fitRecords"});
    } else {
      add(std::make_unique<Fit>(s.get("noiseAmplitude"), storage, features, signal),
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
  add(std::make_unique<AccumulateFiltered>(s.get("filteredLeastWeight")),
      {"fitted", "filtered.prev", "pixelPrev", "reprojectionMask", "historyLength"},
      {"filtered"});
  // clang-format on
  addOutputStages(schedule, configuration, "filtered", s.isOn("taa"));
  return schedule;
}

}  // namespace

Method bmfrMethod() {
  return {"bmfr",        "Blockwise Multi-Order Feature Regression (Koskela et al. 2019)",
          settings(),    makeSchedule,
          discardLimits, checkText};
}

}  // namespace quell

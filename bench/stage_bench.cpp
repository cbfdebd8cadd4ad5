#include "bench/stage_bench.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "host/core/median.hpp"
#include "tests/cases/accumulate_filtered_case.hpp"
#include "tests/cases/accumulate_noisy_case.hpp"
#include "tests/cases/atrous_case.hpp"
#include "tests/cases/background_case.hpp"
#include "tests/cases/blended_sum_case.hpp"
#include "tests/cases/box_filter_case.hpp"
#include "tests/cases/change_sums_case.hpp"
#include "tests/cases/change_weight_case.hpp"
#include "tests/cases/demodulate_case.hpp"
#include "tests/cases/firefly_weights_case.hpp"
#include "tests/cases/fit_case.hpp"
#include "tests/cases/follow_change_case.hpp"
#include "tests/cases/gram_solve_case.hpp"
#include "tests/cases/gram_sums_case.hpp"
#include "tests/cases/guided_evaluate_case.hpp"
#include "tests/cases/guided_moments_case.hpp"
#include "tests/cases/guided_solve_case.hpp"
#include "tests/cases/light_gain_case.hpp"
#include "tests/cases/light_sums_case.hpp"
#include "tests/cases/low_confidence_case.hpp"
#include "tests/cases/median_filter_case.hpp"
#include "tests/cases/remodulate_case.hpp"
#include "tests/cases/separable_bilateral_case.hpp"
#include "tests/cases/soft_history_case.hpp"
#include "tests/cases/sparse_bilateral_case.hpp"
#include "tests/cases/temporal_antialiasing_case.hpp"
#include "tests/cases/variance_case.hpp"
#include "tests/cases/virtual_motion_case.hpp"
#include "tests/cases/weighted_sum_case.hpp"

namespace quell::bench {
namespace {

using tests::CaseOptions;
using tests::ImageLayout;

// Odd on purpose, and of several blocks.
constexpr Size kCheckSize{77, 43};
constexpr int kWarmUps = 3;

template <class Case, class... Arguments>
StageEntry entry(const std::string& name, Mapping mapping, const ImageLayout& layout,
                 Arguments... arguments) {
  return {name, [=](Size size) -> std::unique_ptr<tests::StageCase> {
            CaseOptions options;
            options.size = size;
            options.mapping = mapping;
            options.layout = layout;
            return std::make_unique<Case>(options, arguments...);
          }};
}

// Stages that read or write the caller's images.
void addImageStages(std::vector<StageEntry>& entries, const std::string& variant, Mapping mapping,
                    const ImageLayout& layout) {
  using tests::kFullMaterial;
  const tests::AccumulateNoisyVariant full{kFullMaterial, false};
  entries.push_back(entry<tests::AccumulateNoisyCase>("accumulate_noisy." + variant, mapping, layout, full));
  const tests::AccumulateNoisyVariant guided{kFullMaterial, false, true, false};
  const tests::AccumulateNoisyVariant innovation{kFullMaterial, false, true, false, false, false, true};
  const tests::AccumulateNoisyVariant twoSignals{tests::kTwoSignals, false, true, true};
  entries.push_back(
      entry<tests::AccumulateNoisyCase>("accumulate_noisy.moments_" + variant, mapping, layout, guided));
  entries.push_back(entry<tests::AccumulateNoisyCase>("accumulate_noisy.innovation_" + variant, mapping,
                                                      layout, innovation));
  entries.push_back(entry<tests::AccumulateNoisyCase>("accumulate_noisy.two_signals_" + variant, mapping,
                                                      layout, twoSignals));
  entries.push_back(entry<tests::DemodulateCase>("demodulate." + variant, mapping, layout));
  entries.push_back(entry<tests::RemodulateCase>("remodulate." + variant, mapping, layout, kFullMaterial));
  entries.push_back(
      entry<tests::RemodulateCase>("remodulate.two_signals_" + variant, mapping, layout, tests::kTwoSignals));
  entries.push_back(entry<tests::BackgroundCase>("background." + variant, mapping, layout));
  entries.push_back(entry<tests::RemodulateCase>("remodulate.last_" + variant, mapping, layout, kFullMaterial,
                                                 tests::RemodulateTo::Outputs));
  entries.push_back(
      entry<tests::TemporalAntialiasingCase>("temporal_antialiasing." + variant, mapping, layout));
}

// Stages that only know Quell's own planes.
void addPlaneStages(std::vector<StageEntry>& entries, const std::string& variant, Mapping mapping) {
  const ImageLayout layout = tests::packed(3);
  entries.push_back(entry<tests::FireflyWeightsCase>("firefly_weights." + variant, mapping, layout));
  entries.push_back(entry<tests::FitCase>("fit." + variant, mapping, layout));
  entries.push_back(entry<tests::WeightedSumCase>("weighted_sum." + variant, mapping, layout));
  entries.push_back(entry<tests::AccumulateFilteredCase>("accumulate_filtered." + variant, mapping, layout));
}

// Stages of the wavelet filters: the first and the last iteration of five, without and with all that there is.
void addWaveletStages(std::vector<StageEntry>& entries, const std::string& variant, Mapping mapping) {
  const ImageLayout layout = tests::packed(3);
  for (const int signals : {1, 2}) {
    const std::string name = variant + (signals == 2 ? "_two_signals" : "");
    entries.push_back(entry<tests::VarianceCase>("variance." + name, mapping, layout, signals));
    const tests::AtrousVariant small{{signals, signals == 2}, true, 5, 0.3};
    entries.push_back(entry<tests::AtrousCase>("atrous." + name + "_3x3_step16", mapping, layout, small));
    for (const int iteration : {1, 5}) {
      const tests::AtrousVariant guided{{signals, signals == 2}, true, iteration};
      entries.push_back(entry<tests::AtrousCase>(
          "atrous." + name + "_step" + std::to_string(1 << (iteration - 1)), mapping, layout, guided));
    }
  }
  entries.push_back(entry<tests::VarianceCase>("variance." + variant + "_of_mean", mapping, layout, 1,
                                               tests::VarianceOf::Mean));
  const tests::AtrousVariant plain{{1, false}, false, 1};
  entries.push_back(
      entry<tests::AtrousCase>("atrous." + variant + "_without_variance", mapping, layout, plain));
}

// Stages that follow changes of light.
void addChangeStages(std::vector<StageEntry>& entries, const std::string& variant, Mapping mapping) {
  const ImageLayout layout = tests::packed(3);
  for (const int signals : {1, 2}) {
    const std::string name = variant + (signals == 2 ? "_two_signals" : "");
    entries.push_back(entry<tests::ChangeSumsCase>("change_sums." + name, mapping, layout, signals));
    entries.push_back(entry<tests::ChangeWeightCase>("change_weight." + name, mapping, layout, signals));
    entries.push_back(entry<tests::FollowChangeCase>("follow_change." + name, mapping, layout, signals));
  }
}

// Stages that give back the light that a filter loses.
void addLightStages(std::vector<StageEntry>& entries, const std::string& variant, Mapping mapping) {
  const ImageLayout layout = tests::packed(3);
  for (const int signals : {1, 2}) {
    const std::string name = variant + (signals == 2 ? "_two_signals" : "");
    entries.push_back(entry<tests::LightSumsCase>("light_sums." + name, mapping, layout, signals));
    entries.push_back(entry<tests::LightGainCase>("light_gain." + name, mapping, layout, signals));
  }
}

// Stages of a fit from sums over tiles.
void addGramStages(std::vector<StageEntry>& entries, const std::string& variant, Mapping mapping) {
  const ImageLayout layout = tests::packed(3);
  const std::pair<const char*, GramWindows> allWindows[] = {
      {"", tests::kBlocks}, {"_overlap8", tests::kOverlap8}, {"_overlap16", tests::kOverlap16}};
  for (const auto& [suffix, windows] : allWindows) {
    const std::string name = variant + suffix;
    entries.push_back(entry<tests::GramSumsCase>("gram_sums." + name, mapping, layout, windows));
    entries.push_back(entry<tests::GramSolveCase>("gram_solve." + name, mapping, layout, windows));
    if (windows.overlap)
      entries.push_back(entry<tests::BlendedSumCase>("blended_sum." + name, mapping, layout, windows));
  }
}

// Stages of a guided filter.
void addGuidedStages(std::vector<StageEntry>& entries, const std::string& variant, Mapping mapping) {
  const ImageLayout layout = tests::packed(3);
  for (const int subsampling : {1, 4}) {
    const std::string name = variant + "_cell" + std::to_string(subsampling);
    const tests::GuidedVariant guided{subsampling, 1};
    entries.push_back(entry<tests::GuidedMomentsCase>("guided_moments." + name, mapping, layout, guided));
    entries.push_back(entry<tests::BoxFilterCase>("box_filter." + name + "_columns", mapping, layout,
                                                  tests::BoxPass::MomentColumns, guided));
    entries.push_back(entry<tests::BoxFilterCase>("box_filter." + name + "_rows", mapping, layout,
                                                  tests::BoxPass::MomentRows, guided));
    entries.push_back(entry<tests::GuidedSolveCase>("guided_solve." + name, mapping, layout, guided));
    entries.push_back(entry<tests::GuidedEvaluateCase>("guided_evaluate." + name, mapping, layout, guided));
  }
}

// Stages of edagi.
void addEdagiStages(std::vector<StageEntry>& entries, const std::string& variant, Mapping mapping) {
  const ImageLayout layout = tests::packed(3);
  for (const int signal : {0, 1})
    entries.push_back(entry<tests::SoftHistoryCase>(
        "soft_history." + variant + (signal == 1 ? "_virtual" : ""), mapping, layout, signal));
  entries.push_back(entry<tests::VirtualMotionCase>("virtual_motion." + variant, mapping, layout));
  entries.push_back(entry<tests::LowConfidenceCase>("low_confidence." + variant, mapping, layout));
  entries.push_back(entry<tests::MedianFilterCase>("median_filter." + variant, mapping, layout));
  for (const bool followsConfidence : {false, true})
    entries.push_back(entry<tests::SparseBilateralCase>(
        "sparse_bilateral." + variant + (followsConfidence ? "_by_confidence" : ""), mapping, layout,
        followsConfidence));
  for (const bool alongRows : {false, true})
    entries.push_back(entry<tests::SeparableBilateralCase>(
        "separable_bilateral." + variant + (alongRows ? "_rows" : "_columns"), mapping, layout, alongRows));
}

void checkResult(const StageEntry& stage) {
  const auto stageCase = stage.make(kCheckSize);
  const tests::Comparison comparison = stageCase->check();
  if (!(comparison.largestError() <= stageCase->tolerance()))
    throw std::runtime_error(stage.name + " disagrees with its oracle: " + comparison.worst());
}

}  // namespace

std::vector<StageEntry> stageEntries() {
  std::vector<StageEntry> entries;
  for (const auto& [name, mapping] :
       {std::pair("wide", Mapping::Wide), std::pair("narrow", Mapping::Narrow)}) {
    addImageStages(entries, std::string(name) + "_float3", mapping, tests::packed(3));
    addImageStages(entries, std::string(name) + "_half4", mapping, tests::packedHalf(4));
    addPlaneStages(entries, name, mapping);
    addWaveletStages(entries, name, mapping);
    addChangeStages(entries, name, mapping);
    addLightStages(entries, name, mapping);
    addGramStages(entries, name, mapping);
    addGuidedStages(entries, name, mapping);
    addEdagiStages(entries, name, mapping);
    entries.push_back(entry<tests::FitCase>("fit." + std::string(name) + "_half", mapping, tests::packed(3),
                                            FeatureStorage::Half));
  }
  return entries;
}

StageTimes timeStage(const StageEntry& stage, Size size, int repeat) {
  checkResult(stage);
  const auto stageCase = stage.make(size);
  stageCase->upload();
  for (int i = 0; i < kWarmUps; ++i) stageCase->run();
  std::vector<double> times;
  for (int i = 0; i < repeat; ++i) times.push_back(stageCase->run());
  const auto [least, most] = std::minmax_element(times.begin(), times.end());
  return {median(times), *least, *most, stageCase->bytesMoved()};
}

}  // namespace quell::bench

#include "host/cli/tune/result.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace quell::cli {
namespace {

constexpr char kCommand[] = "tune";

void checkErrors(const Evaluation& evaluation) {
  for (const EvaluatedSetting& setting : evaluation.settings) {
    for (std::size_t i = 0; i < evaluation.sequences.size(); ++i) {
      for (const std::size_t place : minimisedMetrics()) {
        const double error = setting.sequences[i].errors[place];
        if (error > 0.0) continue;
        refuse(kCommand, evaluation.sequences[i].name,
               fmt::format("{} above 0", plainOf(*tunedMetrics()[place]).label),
               fmt::format("{:.2g} with {}", error, setting.plan.name()));
      }
    }
  }
}

// Of value(sequence number).
template <class Value>
double geometricMean(std::size_t sequences, const Value& value) {
  double sum = 0.0;
  for (std::size_t i = 0; i < sequences; ++i) sum += std::log(value(i));
  return std::exp(sum / static_cast<double>(sequences));
}

TunedSetting summarize(const EvaluatedSetting& setting, const EvaluatedSetting& first) {
  const std::size_t count = setting.sequences.size();
  const auto& own = setting.sequences;
  const auto& its = first.sequences;
  TunedSetting result = {setting, {}, 0.0, false};
  result.relative.time = geometricMean(count, [&](std::size_t i) { return own[i].relativeTime; });
  for (const std::size_t place : minimisedMetrics())
    result.relative.errors.push_back(
        geometricMean(count, [&](std::size_t i) { return own[i].errors[place] / its[i].errors[place]; }));
  result.frameMs = geometricMean(count, [&](std::size_t i) { return own[i].frameMs; });
  return result;
}

// The first one, the defaults, and the Pareto set.
std::vector<PlannedRun> bestPlans(const TuningTable& table) {
  std::vector<PlannedRun> plans;
  for (std::size_t i = 0; i < table.settings.size(); ++i)
    if (i == 0 || table.settings[i].pareto) plans.push_back(table.settings[i].figures.plan);
  return plans;
}

}  // namespace

TuningTable summarize(Evaluation evaluation, double timeTolerance) {
  checkErrors(evaluation);
  TuningTable table;
  std::vector<Costs> costs;
  for (const EvaluatedSetting& setting : evaluation.settings) {
    table.settings.push_back(summarize(setting, evaluation.settings.front()));
    costs.push_back(table.settings.back().relative);
  }
  const std::vector<bool> inSet = paretoSet(costs, timeTolerance);
  for (std::size_t i = 0; i < inSet.size(); ++i) table.settings[i].pareto = inSet[i];
  evaluation.settings.clear();
  table.evaluation = std::move(evaluation);
  return table;
}

TuningResult tune(const TuningArguments& arguments, const std::vector<PlannedRun>& plans,
                  const std::vector<BenchInput>& inputs, const std::vector<BenchInput>& confirmation) {
  TuningResult result;
  result.arguments = arguments;
  const auto table = [&](const char* label, const std::vector<PlannedRun>& which, const auto& where) {
    return summarize(evaluateSettings(label, which, where, arguments.evaluation), arguments.timeTolerance);
  };
  result.tuned = table("tune", plans, inputs);
  if (!confirmation.empty()) result.confirmed = table("confirm", bestPlans(result.tuned), confirmation);
  result.copy = mean(result.tuned.evaluation.copies);
  return result;
}

}  // namespace quell::cli

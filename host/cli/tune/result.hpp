// Which settings of a method are worth choosing from, and whether that holds on other sequences.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/cli/tune/evaluation.hpp"
#include "host/cli/tune/pareto_set.hpp"

namespace quell::cli {

/// One setting over all sequences.
struct TunedSetting {
  EvaluatedSetting figures;
  Costs
      relative;  ///< geometric means over the sequences of figures divided by the first setting's; minimised ones
  double frameMs = 0.0;  ///< geometric mean over the sequences
  bool pareto = false;   ///< in the Pareto set of `relative`
};

struct TuningTable {
  Evaluation evaluation;               ///< its settings are in `settings`
  std::vector<TunedSetting> settings;  ///< the defaults first
};

struct TuningArguments {
  std::string method;
  std::string defaults;  ///< default values of what is varied
  double timeTolerance = 0.0;
  EvaluationArguments evaluation;
};

struct TuningResult {
  TuningArguments arguments;
  CopyBandwidth copy;  ///< mean over the sequences
  TuningTable tuned;
  std::optional<TuningTable> confirmed;  ///< the defaults and the Pareto set of `tuned`, on other sequences
};

/// Adds means and the Pareto set. Throws Error(InvalidArgument) naming the sequence for a figure to be minimised that
/// is not above 0: a ratio would mean nothing.
TuningTable summarize(Evaluation evaluation, double timeTolerance);

/// Evaluates `plans` on `inputs`, then the best of them on `confirmation` (may be empty). Throws as evaluateSettings()
/// and summarize().
TuningResult tune(const TuningArguments& arguments, const std::vector<PlannedRun>& plans,
                  const std::vector<BenchInput>& inputs, const std::vector<BenchInput>& confirmation);

}  // namespace quell::cli

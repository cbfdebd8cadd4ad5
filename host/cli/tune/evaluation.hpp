// Errors and times of settings on sequences.
#pragma once

#include <optional>
#include <quell/quell.hpp>
#include <string>
#include <vector>

#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/run_plan.hpp"
#include "host/measure/copy_bandwidth.hpp"
#include "host/metrics/metric_table.hpp"

namespace quell::cli {

/// The metrics that settings are judged by, in the order of reports. Those of the linear output before TAA.
const std::vector<const metrics::Metric*>& tunedMetrics();

/// Places in tunedMetrics() of those that shall become small.
const std::vector<std::size_t>& minimisedMetrics();

/// What takes the metric's place on references of one half, and gives both their name in tables; or the metric itself.
const metrics::Metric& plainOf(const metrics::Metric& metric);

/// Figures of one setting on one sequence.
struct SequenceFigures {
  double frameMs = 0.0;       ///< median over frames and rounds, gaps between stages included
  double relativeTime = 1.0;  ///< frameMs divided by that of the first setting, measured side by side with it
  std::vector<double>
      errors;  ///< of tunedMetrics(), each its mean over the reference frames, as the metric takes it
  std::optional<double> temporalError = {};  ///< over all frames, see metrics::kTemporalError
};

struct EvaluatedSetting {
  PlannedRun plan;
  std::vector<SequenceFigures> sequences;  ///< in the order of the inputs
};

/// A setting that the library refused on one of the sequences.
struct RefusedSetting {
  PlannedRun plan;
  std::string sequence;
  std::string reason;
};

struct EvaluatedSequence {
  std::string name;
  Size size;
  std::size_t frames = 0;
  std::vector<int> references;  ///< numbers of the frames with a reference, at least one
  bool unbiased = true;         ///< all references have two halves
  io::ReferenceKind referenceKind = io::ReferenceKind::Centre;
};

struct Evaluation {
  DeviceInfo device;
  std::vector<EvaluatedSequence> sequences;
  std::vector<EvaluatedSetting> settings;  ///< in the order planned, without the refused ones
  std::vector<RefusedSetting> refused;
  std::vector<CopyBandwidth> copies;  ///< one measurement a sequence
};

struct EvaluationArguments {
  int rounds = 3;  ///< timed rounds over every sequence after the round that measures errors, >= 1
  /// Settings whose denoisers are in memory together, >= 2. Every group contains the first setting.
  int atOnce = 8;
  DeviceArguments device;
};

/// Runs all settings (>= 1) on all sequences, each of which has a reference. Frames go through a group of settings in
/// turn, so that drift of the machine hits them alike, and every group has the first setting in it, by whose time the
/// others' are divided: so groups compare, too. Progress goes to the error stream, labelled `label`.
///
/// Settings other than the first may be refused by the library. Throws whatever the denoiser or the sequences throw.
Evaluation evaluateSettings(const std::string& label, const std::vector<PlannedRun>& plans,
                            const std::vector<BenchInput>& inputs, const EvaluationArguments& arguments);

}  // namespace quell::cli

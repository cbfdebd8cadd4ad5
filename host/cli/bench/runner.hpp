// Runs what was planned so that the times of all runs can be compared.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/cli/bench/build_times.hpp"
#include "host/cli/bench/roofline.hpp"
#include "host/cli/common/command_arguments.hpp"
#include "host/cli/common/denoise_report.hpp"
#include "host/cli/common/run_plan.hpp"
#include "host/measure/copy_bandwidth.hpp"

namespace quell::cli {

/// One run on one sequence.
struct BenchRun {
  std::string input;     ///< name of the sequence
  PlannedRun plan;       ///< what was asked for
  DenoiseReport report;  ///< errors and hash of one round, times over all rounds but the warm-up
  std::optional<BuildTimes> build = {};
  /// Frame times, gaps included, [round][frame], milliseconds; empty where events carry no times.
  std::vector<std::vector<double>> frameMs = {};
};

/// What one run made of a frame, or the frame's input or reference; display-encoded, 3 channels.
struct BenchPicture {
  std::string input;
  int frame = 0;
  std::string name;  ///< the run's, "noisy" or "reference"
  io::Image image;
};

/// A combination that the library refused.
struct SkippedRun {
  std::string input;
  Size size;
  PlannedRun plan;
  std::string reason;
};

/// How to run.
struct BenchOptions {
  int rounds = 1;  ///< timed rounds, >= 1
  DeviceArguments device;
  bool buildTimes = false;  ///< of the first group's runs
  bool fmaRate = false;
  int pictureInputs = 0;  ///< sequences of the first group whose last reference frame is kept as pictures
};

struct BenchResult {
  int rounds = 0;      ///< timed rounds; every run denoises its sequence once a round
  CopyBandwidth copy;  ///< mean of `copyMeasurements`
  std::vector<CopyBandwidth> copyMeasurements;  ///< before and after the rounds of every sequence
  double fmaGigaflops = 0.0;                    ///< 0: not measured
  OperationCounts operations;                   ///< empty: not counted
  std::vector<BenchRun> runs;  ///< group by group, sequence by sequence, in the order planned
  std::vector<SkippedRun> skipped;
  std::vector<BenchPicture> pictures;
};

/// Denoises every sequence of a group with every run of it, so many rounds after a round of warm-up.
///
/// A frame is read once a round and goes through all runs in turn, so that drift of the machine hits all of
/// them alike; who comes first changes from frame to frame. One sequence of one group is worked on at a time, so that
/// memory holds its runs only. Errors are measured in the warm-up round. A round starts without history, except where the
/// group keeps it (BenchGroup::keepsHistory): its timed rounds have one frame less.
///
/// Throws Error(InvalidArgument) if the library refuses every combination, and whatever the denoiser or the
/// sequences throw.
BenchResult runBench(const std::vector<BenchGroup>& groups, const BenchOptions& options);

}  // namespace quell::cli

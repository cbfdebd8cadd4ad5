// Runs what was planned so that the times of all runs can be compared.
#pragma once

#include <string>
#include <vector>

#include "bench/copy_bandwidth.hpp"
#include "host/cli/bench_plan.hpp"
#include "host/cli/command_arguments.hpp"
#include "host/cli/denoise_report.hpp"

namespace quell::cli {

/// One run on one sequence.
struct BenchRun {
  std::string input;     ///< name of the sequence
  PlannedRun plan;       ///< what was asked for
  DenoiseReport report;  ///< errors and hash of one round, times over all rounds but the warm-up
};

/// A combination that the library refused.
struct SkippedRun {
  std::string input;
  Size size;
  PlannedRun plan;
  std::string reason;
};

struct BenchResult {
  int rounds = 0;      ///< timed rounds; every run denoises its sequence once a round
  CopyBandwidth copy;  ///< mean of `copyMeasurements`
  std::vector<CopyBandwidth> copyMeasurements;  ///< before and after the rounds of every sequence
  std::vector<BenchRun> runs;                   ///< sequence by sequence, in the order planned
  std::vector<SkippedRun> skipped;
};

/// Denoises every sequence with every run, `rounds` (>= 1) times after a round of warm-up.
///
/// A frame is read once a round and goes through all runs in turn, so that drift of the machine hits all of
/// them alike; who comes first changes from frame to frame. One sequence is worked on at a time, so that
/// memory holds its runs only. Errors are measured in the warm-up round.
///
/// Throws Error(InvalidArgument) if the library refuses every combination, and whatever the denoiser or the
/// sequences throw.
BenchResult runBench(const std::vector<PlannedRun>& runs, const std::vector<BenchInput>& inputs, int rounds,
                     const DeviceArguments& device);

}  // namespace quell::cli

// How fast a stage could be at best on this device.
#pragma once

#include <map>
#include <quell/timings.hpp>
#include <string>

#include "host/cli/common/run_plan.hpp"

namespace quell::cli {

/// Floating-point operations per pixel that a stage works on, by the run's name and the stage's label; counted by
/// bench/count_operations.
class OperationCounts {
 public:
  OperationCounts() = default;
  /// Reads {"<run>": {"<label>": operations per pixel}}. Throws Error(FileError) or Error(InvalidArgument).
  explicit OperationCounts(const std::string& file);

  /// Those of the very run, else of its method's defaults, else of its method with other settings; 0 where nothing was
  /// counted.
  double perPixel(const PlannedRun& run, const std::string& label) const;

 private:
  std::map<std::string, std::map<std::string, double>> m_counts;
};

/// The pixels that a stage works on over all pixels of its frames, 0 to 1: all but those skipped. Scales what
/// OperationCounts gives.
inline double workShare(const StageTimings& stage) { return 1.0 - stage.skippedShare.value_or(0.0); }

/// The least time that memory and arithmetic allow, milliseconds: the larger of `bytes` at `gigabytesPerSecond` and
/// `operations` at `gigaflops`; a rate of 0 bounds nothing.
double rooflineMs(double bytes, double operations, double gigabytesPerSecond, double gigaflops);

}  // namespace quell::cli

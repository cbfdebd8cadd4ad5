// Device time per stage and frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace quell {

/// Where times come from.
enum class TimeSource {
  Device,  ///< OpenCL event profiling
  Host,    ///< completion callbacks: for runtimes whose events carry no times; includes scheduling delays
};

/// Statistics over the frames since timers were last cleared, at most the latest 4096, milliseconds. Empty:
/// all zero.
struct TimeStatistics {
  std::size_t count = 0;  ///< frames counted, at most 4096
  double medianMs = 0.0;  ///< of an even number of frames the mean of the two in the middle
  double meanMs = 0.0;    ///< drawn up by single slow frames; prefer the median
  double minMs = 0.0;     ///< the fastest frame
  double maxMs = 0.0;     ///< the slowest frame
};

/// Event times of one stage of the latest finished frame, nanoseconds on the device's clock (all 0 with host
/// times).
struct StageEventTimes {
  std::uint64_t queued = 0;  ///< of its first kernel, CL_PROFILING_COMMAND_QUEUED
  std::uint64_t submit = 0;  ///< of its first kernel, CL_PROFILING_COMMAND_SUBMIT
  std::uint64_t start = 0;   ///< of the stage's first kernel
  std::uint64_t end = 0;     ///< of its last kernel
};

/// Times of one line of a method's table.
struct StageTimings {
  std::string stage;             ///< the stem of its kernel file; several lines may share it
  TimeStatistics time;           ///< sum over the stage's kernels
  StageEventTimes last;          ///< of the latest finished frame
  std::uint64_t bytesMoved = 0;  ///< bytes that the stage must read and write per frame, each counted once
  std::string label = {};        ///< the stage's name, with what tells it from others of that name
  /// Work left out over all work, 0 to 1; absent where it is not known, or nothing can be left out.
  std::optional<double> skippedShare = {};
};

/// Times of a denoiser's frames, whole and by stages.
struct Timings {
  TimeSource source = TimeSource::Device;  ///< which of the two the times are of
  TimeStatistics frame;                    ///< start of the first kernel to end of the last, gaps included
  std::vector<StageTimings> stages;  ///< in the order in which a frame runs them; empty if timers are off
};

}  // namespace quell

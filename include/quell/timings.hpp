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
  std::size_t count = 0;
  double medianMs = 0.0;
  double meanMs = 0.0;
  double minMs = 0.0;
  double maxMs = 0.0;
};

/// Event times of one stage of the latest finished frame, nanoseconds on the device's clock (all 0 with host
/// times).
struct StageEventTimes {
  std::uint64_t queued = 0;
  std::uint64_t submit = 0;
  std::uint64_t start = 0;  ///< of the stage's first kernel
  std::uint64_t end = 0;    ///< of its last kernel
};

struct StageTimings {
  std::string stage;
  TimeStatistics time;  ///< sum over the stage's kernels
  StageEventTimes last;
  std::uint64_t bytesMoved = 0;  ///< bytes that the stage must read and write per frame, each counted once
  std::string label = {};        ///< the stage's name, with what tells it from others of that name
  /// Work left out over all work, 0 to 1; absent where it is not known, or nothing can be left out.
  std::optional<double> skippedShare = {};
};

struct Timings {
  TimeSource source = TimeSource::Device;
  TimeStatistics frame;  ///< start of the first kernel to end of the last, gaps included
  std::vector<StageTimings> stages;
};

}  // namespace quell

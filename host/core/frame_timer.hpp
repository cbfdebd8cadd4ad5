// Times of stages and frames, taken from events after the fact; nothing here ever waits.
#pragma once

#include <atomic>
#include <memory>
#include <quell/timings.hpp>
#include <string>
#include <vector>

#include "host/core/opencl.hpp"

namespace quell {

/// Statistics of a list of samples in milliseconds.
TimeStatistics summarise(std::vector<double> samplesMs);

/// Collects the events of frames in flight and turns finished frames into statistics.
class FrameTimer {
 public:
  FrameTimer(std::vector<std::string> stages, TimeSource source);

  /// Event of the next kernel of the frame being recorded, in the order of execution. The frame ends with
  /// endFrame(); frames may be in flight at once.
  void add(std::size_t stage, const cl::Event& event);
  void endFrame();

  /// Reads out all frames that have completed and returns the statistics so far.
  Timings collect();
  void clear();

  /// True if a completed event carries plausible device times (some runtimes report 0 for all of them).
  static bool hasDeviceTimes(const cl::Event& event);

 private:
  struct KernelRecord {
    std::size_t stage = 0;
    cl::Event event;
    std::uint64_t enqueuedNs = 0;
    std::shared_ptr<std::atomic<std::uint64_t>> completedNs;  // host times only; shared with the callback
  };
  struct FrameRecord {
    std::vector<KernelRecord> kernels;
    bool ended = false;
  };

  bool readOut(FrameRecord& frame);

  TimeSource m_source;
  std::vector<std::string> m_stages;
  std::vector<FrameRecord> m_pending;  // the last one is being recorded
  std::vector<std::vector<double>> m_stageMs;
  std::vector<double> m_frameMs;
  std::vector<StageEventTimes> m_last;
};

}  // namespace quell

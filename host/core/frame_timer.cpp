#include "host/core/frame_timer.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <numeric>

#include "host/core/median.hpp"

namespace quell {
namespace {

// No launch is faster; some runtimes (rusticl 22.3) count events instead of nanoseconds.
constexpr std::uint64_t kLeastKernelNs = 10;

constexpr double kMillisecondsPerNanosecond = 1e-6;
// Samples kept per stage; older ones are dropped, so that a renderer that runs for days does not grow.
constexpr std::size_t kMostSamples = 4096;
// Frames whose events are held before finished ones are read out unasked.
constexpr std::size_t kMostPending = 64;

std::uint64_t hostNanoseconds() {
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(
                                        std::chrono::steady_clock::now().time_since_epoch())
                                        .count());
}

// When a command completed by the host's clock; shared with the callback, which may outlive the timer.
using CompletionTime = std::shared_ptr<std::atomic<std::uint64_t>>;

void CL_CALLBACK onComplete(cl_event, cl_int, void* data) {
  const std::unique_ptr<CompletionTime> time(static_cast<CompletionTime*>(data));
  (*time)->store(hostNanoseconds(), std::memory_order_release);
}

void push(std::vector<double>& samples, double value) {
  if (samples.size() == kMostSamples) samples.erase(samples.begin());
  samples.push_back(value);
}

}  // namespace

TimeStatistics summarise(std::vector<double> samplesMs) {
  TimeStatistics result;
  result.count = samplesMs.size();
  if (samplesMs.empty()) return result;
  result.medianMs = median(samplesMs);
  result.meanMs =
      std::accumulate(samplesMs.begin(), samplesMs.end(), 0.0) / static_cast<double>(samplesMs.size());
  const auto [least, most] = std::minmax_element(samplesMs.begin(), samplesMs.end());
  result.minMs = *least;
  result.maxMs = *most;
  return result;
}

FrameTimer::FrameTimer(std::vector<std::string> stages, TimeSource source)
    : m_source(source), m_stages(std::move(stages)), m_stageMs(m_stages.size()), m_last(m_stages.size()) {}

bool FrameTimer::hasDeviceTimes(const cl::Event& event) {
  try {
    return event.getProfilingInfo<CL_PROFILING_COMMAND_END>() >=
           event.getProfilingInfo<CL_PROFILING_COMMAND_START>() + kLeastKernelNs;
  } catch (const cl::Error&) {
    return false;
  }
}

void FrameTimer::add(std::size_t stage, const cl::Event& event) {
  if (m_pending.empty() || m_pending.back().ended) m_pending.emplace_back();
  KernelRecord record;
  record.stage = stage;
  record.event = event;
  if (m_source == TimeSource::Host) {
    record.enqueuedNs = hostNanoseconds();
    record.completedNs = std::make_shared<std::atomic<std::uint64_t>>(0);
    auto data = std::make_unique<CompletionTime>(record.completedNs);
    record.event.setCallback(CL_COMPLETE, onComplete, data.get());
    data.release();  // the callback frees it
  }
  m_pending.back().kernels.push_back(std::move(record));
}

void FrameTimer::endFrame() {
  if (m_pending.empty()) return;
  m_pending.back().ended = true;
  if (m_pending.size() >= kMostPending) collect();  // in case nobody ever asks for times
}

bool FrameTimer::readOut(FrameRecord& frame) {
  std::vector<StageEventTimes> times(m_stages.size());
  std::vector<double> stageMs(m_stages.size(), 0.0);
  std::uint64_t frameStart = 0, frameEnd = 0;
  for (const KernelRecord& kernel : frame.kernels) {
    const cl_int status = kernel.event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>();
    if (status < 0) return true;  // failed: finished, but without times
    if (status != CL_COMPLETE) return false;
    std::uint64_t start = 0, end = 0;
    StageEventTimes& stage = times[kernel.stage];
    if (m_source == TimeSource::Device) {
      start = kernel.event.getProfilingInfo<CL_PROFILING_COMMAND_START>();
      end = kernel.event.getProfilingInfo<CL_PROFILING_COMMAND_END>();
      if (stage.start == 0) {
        stage.queued = kernel.event.getProfilingInfo<CL_PROFILING_COMMAND_QUEUED>();
        stage.submit = kernel.event.getProfilingInfo<CL_PROFILING_COMMAND_SUBMIT>();
        stage.start = start;
      }
      stage.end = end;
    } else {
      end = kernel.completedNs->load(std::memory_order_acquire);
      if (end == 0) return false;  // complete, but its callback has yet to run
      start = std::max(kernel.enqueuedNs, frameEnd);
      end = std::max(start, end);
    }
    stageMs[kernel.stage] += static_cast<double>(end - start) * kMillisecondsPerNanosecond;
    frameStart = frameStart == 0 ? start : std::min(frameStart, start);
    frameEnd = std::max(frameEnd, end);
  }
  for (std::size_t i = 0; i < m_stages.size(); ++i) push(m_stageMs[i], stageMs[i]);
  push(m_frameMs, static_cast<double>(frameEnd - frameStart) * kMillisecondsPerNanosecond);
  m_last = times;
  return true;
}

Timings FrameTimer::collect() {
  std::size_t finished = 0;
  while (finished < m_pending.size() && m_pending[finished].ended && readOut(m_pending[finished])) ++finished;
  m_pending.erase(m_pending.begin(), m_pending.begin() + static_cast<std::ptrdiff_t>(finished));

  Timings timings;
  timings.source = m_source;
  timings.frame = summarise(m_frameMs);
  for (std::size_t i = 0; i < m_stages.size(); ++i)
    timings.stages.push_back({m_stages[i], summarise(m_stageMs[i]), m_last[i]});
  return timings;
}

void FrameTimer::clear() {
  collect();  // frames already finished count as cleared
  m_frameMs.clear();
  for (auto& samples : m_stageMs) samples.clear();
}

}  // namespace quell

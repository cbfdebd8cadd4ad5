// Statistics, and the collection of event times.
#include "host/core/frame_timer.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <functional>
#include <thread>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

// Commands that take a moment on the device, with events.
class Commands {
 public:
  explicit Commands(const OpenDevice& device)
      : m_queue(device.queue), m_buffer(device.context, CL_MEM_READ_WRITE, kBytes) {}
  cl::Event enqueue(const std::vector<cl::Event>& waitFor = {}) {
    cl::Event event;
    m_queue.enqueueFillBuffer(m_buffer, cl_uint(7), 0, kBytes, &waitFor, &event);
    return event;
  }

 private:
  static constexpr std::size_t kBytes = 1 << 16;
  cl::CommandQueue m_queue;
  cl::Buffer m_buffer;
};

// Callbacks run on the runtime's threads: asks until the frames have been counted, for ten seconds at most.
Timings collectFrames(FrameTimer& timer, std::size_t frames) {
  Timings timings = timer.collect();
  for (int attempt = 0; attempt < 10000 && timings.frame.count < frames; ++attempt) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    timings = timer.collect();
  }
  return timings;
}

}  // namespace

TEST_CASE("statistics of no, one, an odd and an even number of samples", "[core]") {
  const TimeStatistics none = summarise({});
  CHECK(none.count == 0);
  for (const double value : {none.medianMs, none.meanMs, none.minMs, none.maxMs}) CHECK(value == 0.0);

  const TimeStatistics one = summarise({2.5});
  CHECK(one.count == 1);
  for (const double value : {one.medianMs, one.meanMs, one.minMs, one.maxMs}) CHECK(value == 2.5);

  const TimeStatistics odd = summarise({9.0, 1.0, 2.0});
  CHECK(odd.count == 3);
  CHECK(odd.medianMs == 2.0);
  CHECK(odd.meanMs == 4.0);
  CHECK(odd.minMs == 1.0);
  CHECK(odd.maxMs == 9.0);

  const TimeStatistics even = summarise({8.0, 1.0, 2.0, 5.0});
  CHECK(even.count == 4);
  CHECK(even.medianMs == 3.5);
  CHECK(even.meanMs == 4.0);
  CHECK(even.minMs == 1.0);
  CHECK(even.maxMs == 8.0);
}

TEST_CASE("device times come from the events, kernels of a stage added up", "[core]") {
  const OpenDevice device(CL_QUEUE_PROFILING_ENABLE);
  Commands commands(device);
  const std::vector<cl::Event> events = {commands.enqueue(), commands.enqueue(), commands.enqueue()};
  device.queue.finish();
  if (!FrameTimer::hasDeviceTimes(events[0])) return;  // a runtime without event times: host times cover it

  FrameTimer timer({"one", "two"}, TimeSource::Device);
  timer.add(0, events[0]);
  timer.add(0, events[1]);
  timer.add(1, events[2]);
  CHECK(timer.collect().frame.count == 0);  // the frame has not ended
  timer.endFrame();
  const Timings timings = timer.collect();

  const auto start = [&](std::size_t i) { return events[i].getProfilingInfo<CL_PROFILING_COMMAND_START>(); };
  const auto end = [&](std::size_t i) { return events[i].getProfilingInfo<CL_PROFILING_COMMAND_END>(); };
  CHECK(timings.source == TimeSource::Device);
  CHECK(timings.frame.count == 1);
  CHECK(timings.frame.medianMs == Approx(double(end(2) - start(0)) * 1e-6));
  REQUIRE(timings.stages.size() == 2);
  CHECK(timings.stages[0].stage == "one");
  CHECK(timings.stages[0].time.medianMs == Approx(double(end(0) - start(0) + end(1) - start(1)) * 1e-6));
  CHECK(timings.stages[0].last.queued == events[0].getProfilingInfo<CL_PROFILING_COMMAND_QUEUED>());
  CHECK(timings.stages[0].last.submit == events[0].getProfilingInfo<CL_PROFILING_COMMAND_SUBMIT>());
  CHECK(timings.stages[0].last.start == start(0));
  CHECK(timings.stages[0].last.end == end(1));
  CHECK(timings.stages[1].time.medianMs == Approx(double(end(2) - start(2)) * 1e-6));
}

TEST_CASE("frames in flight are not waited for", "[core]") {
  const OpenDevice device(CL_QUEUE_PROFILING_ENABLE);
  Commands commands(device);
  for (const TimeSource source : {TimeSource::Device, TimeSource::Host}) {
    FrameTimer timer({"one"}, source);
    timer.add(0, commands.enqueue());
    timer.endFrame();
    CHECK(collectFrames(timer, 1).frame.count == 1);

    Gate gate(device.context);
    const cl::Event pending = commands.enqueue({cl::Event(gate.event(), true)});
    timer.add(0, pending);
    timer.endFrame();
    CHECK(timer.collect().frame.count == 1);
    gate.open();
    pending.wait();
    CHECK(collectFrames(timer, 2).frame.count == 2);
  }
}

TEST_CASE("host times are marked as such and positive", "[core]") {
  const OpenDevice device;
  Commands commands(device);
  FrameTimer timer({"one", "two"}, TimeSource::Host);
  constexpr int kFrames = 3;
  for (int frame = 0; frame < kFrames; ++frame) {
    timer.add(0, commands.enqueue());
    timer.add(1, commands.enqueue());
    timer.endFrame();
  }
  device.queue.finish();
  const Timings timings = collectFrames(timer, kFrames);
  CHECK(timings.source == TimeSource::Host);
  CHECK(timings.frame.count == kFrames);
  CHECK(timings.frame.minMs > 0.0);
  for (const StageTimings& stage : timings.stages) {
    CHECK(stage.time.count == kFrames);
    CHECK(stage.time.minMs >= 0.0);
    CHECK(stage.last.end == 0);
  }
}

TEST_CASE("a timer may go before its events complete", "[core]") {
  const OpenDevice device;
  Commands commands(device);
  Gate gate(device.context);
  const cl::Event pending = commands.enqueue({cl::Event(gate.event(), true)});
  {
    FrameTimer timer({"one"}, TimeSource::Host);
    timer.add(0, pending);
    timer.endFrame();
  }
  gate.open();
  CHECK_NOTHROW(pending.wait());
}

TEST_CASE("a frame that failed leaves no times and does not hold up those after it", "[core]") {
  const OpenDevice device(CL_QUEUE_PROFILING_ENABLE);
  Commands commands(device);
  for (const TimeSource source : {TimeSource::Device, TimeSource::Host}) {
    FrameTimer timer({"one"}, source);
    cl::UserEvent failed(device.context);
    timer.add(0, failed);
    timer.endFrame();
    failed.setStatus(-1);
    timer.add(0, commands.enqueue());
    timer.endFrame();
    device.queue.finish();
    CHECK(collectFrames(timer, 1).frame.count == 1);
  }
}

TEST_CASE("clearing forgets all that has finished", "[core]") {
  const OpenDevice device(CL_QUEUE_PROFILING_ENABLE);
  Commands commands(device);
  FrameTimer timer({"one"}, TimeSource::Device);
  for (int i = 0; i < 2; ++i) {
    timer.add(0, commands.enqueue());
    timer.endFrame();
  }
  device.queue.finish();
  timer.clear();
  const Timings timings = timer.collect();
  CHECK(timings.frame.count == 0);
  REQUIRE(timings.stages.size() == 1);
  CHECK(timings.stages[0].time.count == 0);
}

TEST_CASE("times that nobody collects take bounded memory", "[core]") {
  constexpr int kFrames = 6000;
  constexpr std::size_t kMostSamples = 4096;
  constexpr cl_uint kMostHeld = 100;  // frames whose events are held
  const OpenDevice device(CL_QUEUE_PROFILING_ENABLE);
  Commands commands(device);
  const cl::Event event = commands.enqueue();
  device.queue.finish();
  FrameTimer timer({"one"}, TimeSource::Device);
  const cl_uint before = event.getInfo<CL_EVENT_REFERENCE_COUNT>();
  for (int frame = 0; frame < kFrames; ++frame) {
    timer.add(0, event);
    timer.endFrame();
  }
  CHECK(event.getInfo<CL_EVENT_REFERENCE_COUNT>() < before + kMostHeld);
  CHECK(timer.collect().frame.count == kMostSamples);
  CHECK(event.getInfo<CL_EVENT_REFERENCE_COUNT>() <= before);
}

}  // namespace quell::tests

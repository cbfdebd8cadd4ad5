// Timers of a denoiser.
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kFrames = 3;

// Host times arrive by callback: asks until the frames have been counted, for ten seconds at most.
Timings timingsOf(Denoiser& denoiser, std::size_t frames) {
  Timings timings = denoiser.timings();
  for (int attempt = 0; attempt < 10000 && timings.frame.count < frames; ++attempt) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    timings = denoiser.timings();
  }
  return timings;
}

void checkStatistics(const TimeStatistics& time) {
  CHECK(time.count == kFrames);
  CHECK(time.minMs <= time.medianMs);
  CHECK(time.medianMs <= time.maxMs);
  CHECK(time.minMs <= time.meanMs * (1 + 1e-12));
  CHECK(time.meanMs <= time.maxMs * (1 + 1e-12));
}

}  // namespace

TEST_CASE("device times of the stages add up to no more than the frame", "[core]") {
  for (const cl_command_queue_properties order :
       {cl_command_queue_properties{0},
        cl_command_queue_properties{CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE}}) {
    SmallDenoiser small({}, testOptions(TimerMode::Device), order | CL_QUEUE_PROFILING_ENABLE);
    small.run(0, kFrames - 1);
    Timings timings = timingsOf(small.denoiser, kFrames);
    checkStatistics(timings.frame);
    CHECK(timings.frame.minMs > 0.0);
    REQUIRE(timings.stages.size() > 1);
    CHECK(timings.stages.front().stage == "accumulate_noisy");
    CHECK(timings.stages.back().stage == "temporal_antialiasing");
    double sum = 0.0;
    for (const StageTimings& stage : timings.stages) {
      INFO(stage.stage);
      checkStatistics(stage.time);
      CHECK(stage.bytesMoved > 0);
      sum += stage.time.meanMs;
    }
    CHECK(sum <= timings.frame.meanMs * (1 + 1e-9));
    if (timings.source != TimeSource::Device) continue;  // a runtime without event times
    std::uint64_t before = 0;
    for (const StageTimings& stage : timings.stages) {
      INFO(stage.stage);
      CHECK(stage.last.queued <= stage.last.submit);
      CHECK(stage.last.submit <= stage.last.start);
      CHECK(stage.last.start <= stage.last.end);
      CHECK(before <= stage.last.start);
      before = stage.last.end;
    }
  }
}

TEST_CASE("host times need no profiling queue", "[core]") {
  SmallDenoiser small({}, testOptions(TimerMode::Host));
  small.run(0, kFrames - 1);
  const Timings timings = timingsOf(small.denoiser, kFrames);
  CHECK(timings.source == TimeSource::Host);
  checkStatistics(timings.frame);
  CHECK(timings.frame.minMs > 0.0);
  CHECK(timings.stages.size() > 1);
}

TEST_CASE("timers change no pixel", "[core]") {
  CHECK(SmallDenoiser({}, testOptions(TimerMode::Host)).run(0, kFrames - 1) ==
        SmallDenoiser().run(0, kFrames - 1));
}

TEST_CASE("without timers there are no times", "[core]") {
  SmallDenoiser small;
  small.run(0);
  CHECK(small.denoiser.timings().frame.count == 0);
  CHECK(small.denoiser.timings().stages.empty());
  CHECK_NOTHROW(small.denoiser.clearTimings());
}

TEST_CASE("times are cleared on demand and by prepare(), and the warm-up is not among them", "[core]") {
  SmallDenoiser small({}, testOptions(TimerMode::Device), CL_QUEUE_PROFILING_ENABLE);
  CHECK(small.denoiser.timings().frame.count == 0);
  small.run(0, kFrames - 1);
  CHECK(timingsOf(small.denoiser, kFrames).frame.count == kFrames);
  small.denoiser.clearTimings();
  CHECK(small.denoiser.timings().frame.count == 0);
  small.run(0);
  CHECK(timingsOf(small.denoiser, 1).frame.count == 1);
  small.denoiser.prepare(small.buffers.frame, small.buffers.output);
  CHECK(small.denoiser.timings().frame.count == 0);
}

TEST_CASE("asking for times never waits for a frame", "[core]") {
  SmallDenoiser small({}, testOptions(TimerMode::Host));
  Gate gate(small.device.context);
  const Event done = small.enqueue({gate.event()});
  CHECK(small.denoiser.timings().frame.count == 0);
  gate.open();
  done.wait();
  CHECK(timingsOf(small.denoiser, 1).frame.count == 1);
}

}  // namespace quell::tests

// Wait lists that cannot be waited for, and events that fail.
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr cl_command_queue_properties kQueues[] = {0, CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE};

// Denoises behind an event that then fails.
void failFrame(SmallDenoiser& small) {
  Gate gate(small.device.context);
  const Event done = small.enqueue({gate.event()});
  gate.fail();
  checkRefused({ErrorCode::DeviceError, "denoise", "", "clWaitForEvents", "CL_EXEC_STATUS_ERROR"},
               [&] { done.wait(); });
}

}  // namespace

TEST_CASE("a null event in the wait list is refused", "[errors]") {
  SmallDenoiser small;
  Gate gate(small.device.context);
  checkRefused({ErrorCode::InvalidArgument, "denoise", "waitList", "events", "a null event"}, [&] {
    small.enqueue({gate.event(), nullptr});
  });
  checkStillWorks(small);
}

TEST_CASE("an event of another context is refused", "[errors]") {
  SmallDenoiser small;
  const OpenDevice other;
  const Gate gate(other.context);
  checkRefused({ErrorCode::WrongContext, "denoise", "waitList", "the denoiser's context", "another"},
               [&] { small.enqueue({gate.event()}); });
  checkStillWorks(small);
}

TEST_CASE("a frame whose wait list fails, fails and writes nothing", "[errors]") {
  for (const cl_command_queue_properties properties : kQueues) {
    SmallDenoiser small({}, testOptions(), properties);
    const Picture untouched = small.buffers.download();
    failFrame(small);
    CHECK(small.buffers.download() == untouched);
  }
}

TEST_CASE("after a failed frame the sequence starts afresh", "[errors]") {
  for (const cl_command_queue_properties properties : kQueues) {
    SmallDenoiser small({}, testOptions(), properties);
    const Picture expected = small.run(0, 1);
    failFrame(small);
    CHECK(small.run(0, 1) == expected);
    failFrame(small);
    CHECK_NOTHROW(small.denoiser.prepare(small.buffers.frame, small.buffers.output));
    CHECK(small.run(0, 1) == expected);
  }
}

TEST_CASE("a failed frame leaves no times", "[errors]") {
  for (const TimerMode timers : {TimerMode::Device, TimerMode::Host}) {
    SmallDenoiser small({}, testOptions(timers), CL_QUEUE_PROFILING_ENABLE);
    failFrame(small);
    CHECK(small.denoiser.timings().frame.count == 0);
    checkStillWorks(small);
  }
}

TEST_CASE("a denoiser may go after its frame has failed", "[errors]") {
  for (const cl_command_queue_properties properties : kQueues) {
    SmallDenoiser small({}, testOptions(TimerMode::Host), properties);
    CHECK_NOTHROW(failFrame(small));
  }
}

TEST_CASE("an event that has failed already is refused", "[errors]") {
  for (const cl_command_queue_properties properties : kQueues) {
    SmallDenoiser small({}, testOptions(), properties);
    const Picture untouched = small.buffers.download();
    Gate gate(small.device.context);
    gate.fail();
    checkRefused({ErrorCode::DeviceError, "denoise", "waitList", "have not failed", "status"},
                 [&] { small.enqueue({gate.event()}); });
    CHECK(small.buffers.download() == untouched);
    checkStillWorks(small);
  }
}

}  // namespace quell::tests

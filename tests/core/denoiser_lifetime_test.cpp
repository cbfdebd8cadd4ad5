// Denoisers come and go while work is pending; several live side by side.
#include <catch2/catch.hpp>
#include <chrono>
#include <optional>
#include <thread>

#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

constexpr int kLastFrame = 3;

// Prepared for the buffers of `small`, with the same queue.
Denoiser anotherFor(SmallDenoiser& small, const Options& options) {
  Denoiser denoiser(small.device.context, small.device.device, small.device.queue, Settings(), options);
  denoiser.prepare(small.buffers.frame, small.buffers.output);
  return denoiser;
}

}  // namespace

TEST_CASE("a denoiser may go while its frame is pending", "[core]") {
  for (const cl_command_queue_properties properties :
       {cl_command_queue_properties{0},
        cl_command_queue_properties{CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE}}) {
    for (const TimerMode timers : {TimerMode::Off, TimerMode::Host}) {
      SmallDenoiser small({}, testOptions(), properties);
      const Picture expected = small.run(0);
      small.buffers.upload(0);
      std::optional<Denoiser> doomed(anotherFor(small, testOptions(timers)));
      Gate gate(small.device.context);
      const Event done = doomed->denoise(small.buffers.frame, small.buffers.output, {gate.event()});
      doomed.reset();
      CHECK(statusOf(done) > CL_RUNNING);
      gate.open();
      done.wait();
      CHECK(small.buffers.download() == expected);
    }
  }
}

TEST_CASE("a denoiser that went while frames were pending lets go of its queue when they end", "[core]") {
  const OpenDevice device;
  for (const cl_command_queue_properties properties :
       {cl_command_queue_properties{0},
        cl_command_queue_properties{CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE}}) {
    cl::CommandQueue queue(device.context, device.device, properties);
    const cl_uint before = queue.getInfo<CL_QUEUE_REFERENCE_COUNT>();
    {
      const FrameBuffers buffers(device,
                                 {});  // on some runtimes memory refers to the queue that wrote it last
      Gate gate(device.context);
      Denoiser doomed(device.context, device.device, queue, Settings(), testOptions());
      doomed.prepare(buffers.frame, buffers.output);
      for (int number = 0; number < 3; ++number)
        doomed.denoise(buffers.frame, buffers.output,
                       number == 0 ? std::vector<cl_event>{gate.event()} : std::vector<cl_event>{});
    }
    queue.finish();
    // Callbacks may come a little after the end of what they wait for.
    for (int i = 0; i < 500 && queue.getInfo<CL_QUEUE_REFERENCE_COUNT>() > before; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(queue.getInfo<CL_QUEUE_REFERENCE_COUNT>() == before);
  }
}

TEST_CASE("an event that nobody keeps does no harm", "[core]") {
  SmallDenoiser small;
  const Picture expected = small.run(0);
  small.denoiser.resetHistory();
  small.buffers.upload(0);
  {
    Gate gate(small.device.context);
    small.enqueue({gate.event()});
    gate.open();
  }
  small.device.queue.finish();
  CHECK(small.buffers.download() == expected);
}

TEST_CASE("a denoiser can be moved", "[core]") {
  SmallDenoiser small;
  small.run(0, kLastFrame - 1);
  Denoiser moved(std::move(small.denoiser));
  small.buffers.upload(kLastFrame);
  moved.denoise(small.buffers.frame, small.buffers.output).wait();
  CHECK(small.buffers.download() == SmallDenoiser().run(0, kLastFrame));
}

TEST_CASE("handles may be released by the caller as soon as the denoiser has them", "[core]") {
  SmallDenoiser small;
  const Picture expected = small.run(0);
  small.buffers.upload(0);
  std::optional<Denoiser> denoiser;
  {
    const cl::CommandQueue queue(small.device.context, small.device.device);
    denoiser.emplace(small.device.context, small.device.device, queue, Settings(), testOptions());
  }
  denoiser->prepare(small.buffers.frame, small.buffers.output);
  denoiser->denoise(small.buffers.frame, small.buffers.output).wait();
  CHECK(small.buffers.download() == expected);
}

TEST_CASE("two denoisers on queues of one context do not disturb each other", "[core]") {
  SmallDenoiser small;
  const Picture expected = small.run(0, kLastFrame);
  const cl::CommandQueue otherQueue(small.device.context, small.device.device);
  FrameBuffers otherBuffers(small.device, {});
  Denoiser other(small.device.context, small.device.device, otherQueue, Settings(), testOptions());
  other.prepare(otherBuffers.frame, otherBuffers.output);
  small.denoiser.resetHistory();
  for (int number = 0; number <= kLastFrame; ++number) {
    small.buffers.upload(number);
    otherBuffers.upload(number);
    const Event first = small.enqueue();
    const Event second = other.denoise(otherBuffers.frame, otherBuffers.output);
    first.wait();
    second.wait();
  }
  CHECK(small.buffers.download() == expected);
  CHECK(otherBuffers.download() == expected);
}

TEST_CASE("several threads may use a denoiser by turns and denoisers of their own at once", "[core]") {
  const Picture expected = SmallDenoiser().run(0, kLastFrame);
  SmallDenoiser shared;
  for (int number = 0; number <= kLastFrame; ++number) std::thread([&] { shared.run(number); }).join();
  CHECK(shared.buffers.download() == expected);

  std::array<Picture, 3> pictures;
  std::vector<std::thread> threads;
  for (Picture& picture : pictures)
    threads.emplace_back([&picture] { picture = SmallDenoiser().run(0, kLastFrame); });
  for (std::thread& thread : threads) thread.join();
  for (const Picture& picture : pictures) CHECK(picture == expected);
}

}  // namespace quell::tests

// A renderer's queues, events and threads around an installed Quell: whatever the order of calls, the pictures are
// those of a run that does one thing at a time, bit by bit.
#include <array>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <memory>
#include <mutex>
#include <quell/quell.hpp>
#include <thread>
#include <vector>

#include "renderer.hpp"

namespace embedding {
namespace {

constexpr int kFrames = 4;
using Pictures = std::array<Picture, kFrames>;

/// A renderer and a denoiser on a queue of their own.
class Pipeline {
 public:
  Pipeline(const Device& device, cl_command_queue_properties properties)
      : m_device(device),
        m_queue(device.makeQueue(properties)),
        m_renderer(device, m_queue),
        m_denoiser(std::make_unique<quell::Denoiser>(device.context.get(), device.id, m_queue.get())) {
    m_denoiser->prepare(m_renderer.frame(0), m_renderer.output());
  }

  /// Enqueues trace, denoise and read of a frame, joined by events alone.
  void enqueue(int number) {
    std::vector<cl_event> waitFor;
    if (number > 0) waitFor.push_back(m_read.get());  // the buffers are free again
    const Event traced = m_renderer.trace(number, waitFor);
    const Event denoised(
        m_denoiser->denoise(m_renderer.frame(number), m_renderer.output(), {traced.get()}).release());
    m_read = m_renderer.read(m_pictures[static_cast<std::size_t>(number)], denoised.get());
  }

  void finish() { check(clFinish(m_queue.get()), "clFinish"); }

  /// Frame 0 behind a closed gate; the denoiser goes before the gate opens.
  void enqueueAndDestroy() {
    cl_int code = CL_SUCCESS;
    const Event gate(clCreateUserEvent(m_device.context.get(), &code));
    check(code, "clCreateUserEvent");
    const Event traced = m_renderer.trace(0, {});
    const Event denoised(
        m_denoiser->denoise(m_renderer.frame(0), m_renderer.output(), {traced.get(), gate.get()}).release());
    m_denoiser.reset();
    m_read = m_renderer.read(m_pictures[0], denoised.get());
    check(clSetUserEventStatus(gate.get(), CL_COMPLETE), "clSetUserEventStatus");
    finish();
  }

  const Pictures& pictures() const { return m_pictures; }

 private:
  const Device& m_device;
  Queue m_queue;
  Renderer m_renderer;
  std::unique_ptr<quell::Denoiser> m_denoiser;
  Event m_read;
  Pictures m_pictures;
};

Pictures oneThingAtATime(const Device& device) {
  Pipeline pipeline(device, 0);
  for (int number = 0; number < kFrames; ++number) {
    pipeline.enqueue(number);
    pipeline.finish();
  }
  return pipeline.pictures();
}

Pictures allAtOnce(const Device& device, cl_command_queue_properties properties) {
  Pipeline pipeline(device, properties);
  for (int number = 0; number < kFrames; ++number) pipeline.enqueue(number);
  pipeline.finish();
  return pipeline.pictures();
}

std::array<Pictures, 2> twoDenoisers(const Device& device) {
  Pipeline first(device, 0), second(device, CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
  for (int number = 0; number < kFrames; ++number) {
    first.enqueue(number);
    second.enqueue(number);
  }
  first.finish();
  second.finish();
  return {first.pictures(), second.pictures()};
}

Pictures twoThreadsByTurns(const Device& device) {
  Pipeline pipeline(device, 0);
  std::mutex mutex;
  std::condition_variable turnTaken;
  int next = 0;
  std::exception_ptr failure;
  const auto work = [&](int mine) {
    for (int number = mine; number < kFrames; number += 2) {
      std::unique_lock<std::mutex> lock(mutex);
      turnTaken.wait(lock, [&] { return next == number; });
      try {
        if (!failure) pipeline.enqueue(number);
      } catch (...) {
        failure = std::current_exception();
      }
      ++next;
      turnTaken.notify_all();
    }
  };
  std::thread even(work, 0), odd(work, 1);
  even.join();
  odd.join();
  if (failure) std::rethrow_exception(failure);
  pipeline.finish();
  return pipeline.pictures();
}

Picture destroyedWhilePending(const Device& device, cl_command_queue_properties properties) {
  Pipeline pipeline(device, properties);
  pipeline.enqueueAndDestroy();
  return pipeline.pictures()[0];
}

int report(bool equal, const char* what) {
  std::printf("%s: %s\n", what, equal ? "equal" : "DIFFERENT PICTURES");
  return equal ? 0 : 1;
}

/// The expected pictures must be worth comparing with: denoised, and no two the same.
bool arePictures(const Pictures& pictures) {
  for (const Picture& picture : pictures)
    for (const float value : picture.display)
      if (!(value >= 0.0f && value <= 1.0f)) return false;
  return !(pictures[0] == pictures[1]) && !(pictures[2] == pictures[3]);
}

int run() {
  constexpr cl_command_queue_properties kInOrder = 0, kOutOfOrder = CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE;
  const Device device;
  const Pictures expected = oneThingAtATime(device);
  int failures = report(arePictures(expected) && oneThingAtATime(device) == expected, "one thing at a time");
  failures += report(allAtOnce(device, kInOrder) == expected, "in-order queue, joined by events");
  failures += report(allAtOnce(device, kOutOfOrder) == expected, "out-of-order queue, joined by events");
  const std::array<Pictures, 2> two = twoDenoisers(device);
  failures += report(two[0] == expected && two[1] == expected, "two denoisers on two queues");
  failures += report(twoThreadsByTurns(device) == expected, "one denoiser, two threads by turns");
  failures += report(destroyedWhilePending(device, kInOrder) == expected[0] &&
                         destroyedWhilePending(device, kOutOfOrder) == expected[0],
                     "destroyed while its event is pending");
  return failures;
}

}  // namespace
}  // namespace embedding

int main() {
  try {
    return embedding::run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

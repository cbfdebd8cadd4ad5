// The kernels of one frame on their way into the queue.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "host/core/opencl.hpp"

namespace quell {

/// Events of the kernels of a frame, each with the index of its stage, in the order of execution.
using EventChain = std::vector<std::pair<std::size_t, cl::Event>>;

class FrameCommands {
 public:
  /// The first kernel waits for `waitFor`; with `chain` each further one for the one before. With `keepEvents` the
  /// events of all kernels are kept, as timers need them.
  FrameCommands(const cl::CommandQueue& queue, std::vector<cl::Event> waitFor, bool chain, bool keepEvents)
      : m_queue(queue), m_waitFor(std::move(waitFor)), m_chain(chain), m_keepEvents(keepEvents) {}

  /// `last`: of the frame's stages.
  void enqueue(std::size_t stage, bool last, const cl::Kernel& kernel, const cl::NDRange& range,
               const cl::NDRange& local);
  /// Commands that no stage counts, ahead of the frame.
  void enqueueAhead(const cl::Kernel& kernel, const cl::NDRange& range, const cl::NDRange& local);
  void fillWithZeros(const cl::Buffer& buffer, std::size_t bytes);

  bool isChain() const { return m_chain; }
  const cl::Event& lastEvent() const { return m_lastEvent; }
  const EventChain& events() const { return m_events; }

 private:
  template <class Enqueue>
  void add(std::size_t stage, bool last, Enqueue&& enqueue);

  const cl::CommandQueue& m_queue;
  std::vector<cl::Event> m_waitFor;
  bool m_chain;
  bool m_keepEvents;
  cl::Event m_lastEvent;
  EventChain m_events;
};

}  // namespace quell

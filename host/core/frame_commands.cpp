#include "host/core/frame_commands.hpp"

namespace quell {

void FrameCommands::enqueue(std::size_t stage, bool last, const cl::Kernel& kernel, const cl::NDRange& range,
                            const cl::NDRange& local) {
  add(stage, last, [&](const std::vector<cl::Event>* waitFor, cl::Event* event) {
    m_queue.enqueueNDRangeKernel(kernel, cl::NullRange, range, local, waitFor, event);
  });
}

void FrameCommands::enqueueAhead(const cl::Kernel& kernel, const cl::NDRange& range,
                                 const cl::NDRange& local) {
  enqueue(0, false, kernel, range, local);
}

void FrameCommands::fillWithZeros(const cl::Buffer& buffer, std::size_t bytes) {
  add(0, false, [&](const std::vector<cl::Event>* waitFor, cl::Event* event) {
    m_queue.enqueueFillBuffer(buffer, cl_uchar(0), 0, bytes, waitFor, event);
  });
}

template <class Enqueue>
void FrameCommands::add(std::size_t stage, bool last, Enqueue&& enqueue) {
  const bool wantEvent = m_chain || m_keepEvents || last;
  cl::Event event;
  enqueue(m_waitFor.empty() ? nullptr : &m_waitFor, wantEvent ? &event : nullptr);
  m_waitFor.clear();
  if (m_chain) m_waitFor.push_back(event);
  if (m_keepEvents || m_chain) m_events.emplace_back(stage, event);
  m_lastEvent = event;
}

}  // namespace quell

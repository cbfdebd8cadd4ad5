#include "host/core/frame_commands.hpp"

namespace quell {

void FrameCommands::enqueue(std::size_t stage, bool last, const cl::Kernel& kernel, const cl::NDRange& range,
                            const cl::NDRange& local) {
  const bool wantEvent = m_chain || m_keepEvents || last;
  cl::Event event;
  m_queue.enqueueNDRangeKernel(kernel, cl::NullRange, range, local, m_waitFor.empty() ? nullptr : &m_waitFor,
                               wantEvent ? &event : nullptr);
  m_waitFor.clear();
  if (m_chain) m_waitFor.push_back(event);
  if (m_keepEvents || m_chain) m_events.emplace_back(stage, event);
  m_lastEvent = event;
}

}  // namespace quell

#include "host/core/event_keeper.hpp"

#include <algorithm>
#include <memory>
#include <mutex>

namespace quell {
namespace {

bool isDone(const EventChain& chain) {
  return chain.back().second.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() <= CL_COMPLETE;
}

/// Keeps the events of a failed frame as long as the process.
void keepForever(EventChain chain) noexcept {
  static std::mutex mutex;
  static auto* const kept =
      new std::deque<EventChain>;  // never destroyed: a runtime may outlive static objects
  try {
    const std::lock_guard<std::mutex> lock(mutex);
    kept->push_back(std::move(chain));
  } catch (...) {
    // Nothing that a caller could do about it.
  }
}

void CL_CALLBACK onEnd(cl_event, cl_int status, void* data) {
  const std::unique_ptr<EventChain> chain(static_cast<EventChain*>(data));
  if (status != CL_COMPLETE) keepForever(std::move(*chain));
}

/// Keeps the events of a frame that has failed, or is still pending when its denoiser goes: the latter until it ends.
void outliveDenoiser(EventChain chain) noexcept {
  try {
    auto held = std::make_unique<EventChain>(std::move(chain));
    held->back().second.setCallback(CL_COMPLETE, onEnd, held.get());
    static_cast<void>(held.release());  // the callback's
  } catch (...) {
    // Without a callback they go now.
  }
}

}  // namespace

bool hasFailed(const cl::Event& event) {
  return event() != nullptr && event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() < 0;
}

EventKeeper::~EventKeeper() {
  for (EventChain& chain : m_chains) outliveDenoiser(std::move(chain));
}

void EventKeeper::keep(const EventChain& events) {
  while (!m_chains.empty() && isDone(m_chains.front())) m_chains.pop_front();
  if (!events.empty()) m_chains.push_back(events);
}

bool EventKeeper::takeFailed() {
  const auto firstFailed =
      std::stable_partition(m_chains.begin(), m_chains.end(),
                            [](const EventChain& chain) { return !hasFailed(chain.back().second); });
  if (firstFailed == m_chains.end()) return false;
  for (auto chain = firstFailed; chain != m_chains.end(); ++chain) keepForever(std::move(*chain));
  m_chains.erase(firstFailed, m_chains.end());
  return true;
}

}  // namespace quell

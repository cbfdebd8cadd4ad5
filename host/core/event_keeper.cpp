#include "host/core/event_keeper.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>

namespace quell {
namespace {

bool isDone(const EventChain& chain) {
  return chain.back().second.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() <= CL_COMPLETE;
}

/// Keeps the chains of frames that have failed, or are still pending when their denoiser goes.
void outliveDenoiser(std::deque<EventChain> chains) noexcept {
  static std::mutex mutex;
  static auto* const kept =
      new std::deque<EventChain>;  // never destroyed: a runtime may outlive static objects
  try {
    const std::lock_guard<std::mutex> lock(mutex);
    const auto hasSucceeded = [](const EventChain& chain) {
      return chain.back().second.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() == CL_COMPLETE;
    };
    kept->erase(std::remove_if(kept->begin(), kept->end(), hasSucceeded), kept->end());
    for (EventChain& chain : chains)
      if (!hasSucceeded(chain)) kept->push_back(std::move(chain));
  } catch (...) {
    // Nothing that a caller could do about it.
  }
}

}  // namespace

bool hasFailed(const cl::Event& event) {
  return event() != nullptr && event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() < 0;
}

EventKeeper::~EventKeeper() { outliveDenoiser(std::move(m_chains)); }

void EventKeeper::keep(const EventChain& events) {
  while (!m_chains.empty() && isDone(m_chains.front())) m_chains.pop_front();
  if (!events.empty()) m_chains.push_back(events);
}

bool EventKeeper::takeFailed() {
  const auto firstFailed =
      std::stable_partition(m_chains.begin(), m_chains.end(),
                            [](const EventChain& chain) { return !hasFailed(chain.back().second); });
  if (firstFailed == m_chains.end()) return false;
  outliveDenoiser({std::make_move_iterator(firstFailed), std::make_move_iterator(m_chains.end())});
  m_chains.erase(firstFailed, m_chains.end());
  return true;
}

}  // namespace quell

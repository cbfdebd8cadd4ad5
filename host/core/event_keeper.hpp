// Events of frames in flight, kept until they are done. Some runtimes touch events of a chain that fails after they have
// given them back (PoCL 3.1), so that references of our own must outlast the failure: those of failed frames last as long
// as the process.
#pragma once

#include <deque>

#include "host/core/frame_commands.hpp"

namespace quell {

class EventKeeper {
 public:
  EventKeeper() = default;
  EventKeeper(const EventKeeper&) = delete;
  EventKeeper& operator=(const EventKeeper&) = delete;
  /// What is still pending is kept until it ends; then queue and context are let go of.
  ~EventKeeper();

  void keep(const EventChain& events);
  /// Whether a frame has failed since the last call.
  bool takeFailed();

 private:
  std::deque<EventChain> m_chains;
};

/// Whether the event exists and its command has failed.
bool hasFailed(const cl::Event& event);

}  // namespace quell

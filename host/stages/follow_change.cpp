#include "host/stages/follow_change.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(FollowChangeOptions, FOLLOW_CHANGE)

FollowChange::FollowChange(const Configuration& configuration, const ChangeDetection& detection, bool skip)
    : m_detection(detection) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  changeTiles = tileCount(configuration.size(), QUELL_SIGNALS);
  setSkipOptions<FollowChangeOptions>(*this, configuration, skip);
}

ChangeParams FollowChange::params(const FrameRun& run) const {
  return makeChangeParams(m_detection, run.frame.size);
}

}  // namespace quell

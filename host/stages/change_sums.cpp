#include "host/stages/change_sums.hpp"

#include "host/core/frame_images.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(ChangeSumsOptions, CHANGE_SUMS)

ChangeSums::ChangeSums(const Configuration& configuration, const ChangeDetection& detection)
    : m_detection(detection) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  changeTiles = tileCount(configuration.size(), QUELL_SIGNALS);
}

ChangeParams ChangeSums::params(const FrameRun& run) const {
  ChangeParams params = makeChangeParams(m_detection, run.frame.size);
  // A restarted history has no sums.
  if (run.frameIndex == 0) params.sumsKept = 0.0f;
  return params;
}

}  // namespace quell

#include "host/stages/change_weight.hpp"

#include "host/core/frame_images.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(ChangeWeightOptions, CHANGE_WEIGHT)

ChangeWeight::ChangeWeight(const Configuration& configuration, const ChangeDetection& detection)
    : m_detection(detection) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  changeTiles = tileCount(configuration.size(), QUELL_SIGNALS);
}

ChangeParams ChangeWeight::params(const FrameRun& run) const {
  ChangeParams params = makeChangeParams(m_detection, run.frame.size);
  params.restarted = run.frameIndex == 0 ? 1 : 0;
  return params;
}

}  // namespace quell

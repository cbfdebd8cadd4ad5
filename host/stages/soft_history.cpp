#include "host/stages/soft_history.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(SoftHistoryOptions, SOFT_HISTORY)

SoftHistory::SoftHistory(const Configuration& configuration, const Setup& setup) : m_setup(setup) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  QUELL_SIGNAL = setup.signal;
  clamps = setup.clampSigma > 0.0 ? 1 : 0;
  VIRTUAL = setup.virtualPositions ? 1 : 0;
  setSkipOptions<SoftHistoryOptions>(*this, configuration, setup.skip);
}

SoftHistoryParams SoftHistory::params(const FrameRun& run) const {
  SoftHistoryParams params{};
  params.reprojection = run.reprojection;
  params.planes = makePlanes(run.frame.size);
  params.hysteresis = static_cast<float>(m_setup.hysteresis);
  params.nearDistance = static_cast<float>(m_setup.nearDistance);
  params.farDistance = static_cast<float>(m_setup.farDistance);
  params.nearFootprint = static_cast<float>(m_setup.nearFootprints) * run.reprojection.footprint;
  params.farFootprint = static_cast<float>(m_setup.farFootprints) * run.reprojection.footprint;
  params.clampSigma = static_cast<float>(m_setup.clampSigma);
  params.meanFirst = m_setup.meanFirst ? 1 : 0;
  params.trustsMotion = run.frame.motion.present() && !m_setup.virtualPositions ? 1 : 0;
  return params;
}

}  // namespace quell

#include "host/stages/variance.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(VarianceOptions, VARIANCE)

Variance::Variance(const Configuration& configuration, const Setup& setup) : m_setup(setup) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  OF_MEAN = setup.ofMean ? 1 : 0;
  STOP_LUMINANCE = setup.stopLuminance ? 1 : 0;
  FIREFLIES = setup.fireflyRatio > 0.0 ? 1 : 0;
  ROUGHNESS_STOP = 0;  // moments are of all signals alike
  temporalFrames = setup.temporalFrames;
  setSkipOptions<VarianceOptions>(*this, configuration, setup.skip);
}

VarianceParams Variance::params(const FrameRun& run) const {
  VarianceParams params{};
  params.planes = makePlanes(run.frame.size);
  params.stops = makeEdgeStopParams(m_setup.stops);
  params.fireflyRatio = static_cast<float>(m_setup.fireflyRatio);
  params.momentsFrames = static_cast<float>(1.0 / m_setup.momentsLeastWeight);
  params.temporalFrames = m_setup.temporalFrames;
  return params;
}

}  // namespace quell

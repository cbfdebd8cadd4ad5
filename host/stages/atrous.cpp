#include "host/stages/atrous.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(AtrousOptions, ATROUS)

Atrous::Atrous(const Configuration& configuration, const Setup& setup) : m_setup(setup) {
  const bool readsRoughness = setup.stops.roughnessSigma > 0.0 || setup.sharpRoughness > 0.0;
  QUELL_SIGNALS = signalCount(configuration.frame);
  VARIANCE = setup.variance ? 1 : 0;
  STOP_LUMINANCE = setup.stopLuminance ? 1 : 0;
  TAP_WEIGHTS = setup.tapWeights ? 1 : 0;
  ROUGHNESS_STOP = configuration.frame.roughness.present() && readsRoughness ? 1 : 0;
  TAP_RADIUS = setup.radius;
  filtersVariance = setup.variance && setup.filterVariance ? 1 : 0;
  setSkipOptions<AtrousOptions>(*this, configuration, setup.skip);
}

AtrousParams Atrous::params(const FrameRun& run) const {
  AtrousParams params{};
  params.planes = makePlanes(run.frame.size);
  params.stops = makeEdgeStopParams(m_setup.stops);
  params.luminanceSigma = static_cast<float>(m_setup.luminanceSigma);
  params.inverseStep = 1.0f / static_cast<float>(step());
  params.step = step();
  params.iteration = m_setup.iteration;
  params.corners = m_setup.corners ? 1 : 0;
  params.filtersVariance = filtersVariance != 0 ? 1 : 0;
  if (m_setup.sharpRoughness > 0.0) {
    params.sharpening = 1.0f;
    params.inverseSharpRoughness = static_cast<float>(1.0 / m_setup.sharpRoughness);
  }
  return params;
}

}  // namespace quell

#include "host/stages/separable_bilateral.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(SeparableBilateralOptions, SEPARABLE_BILATERAL)

SeparableBilateral::SeparableBilateral(const Configuration& configuration, const Setup& setup)
    : m_setup(setup) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  QUELL_SIGNAL = setup.signal;
  ROUGHNESS_STOP = configuration.frame.roughness.present() ? 1 : 0;
  setSkipOptions<SeparableBilateralOptions>(*this, configuration, setup.skip);
}

SeparableBilateralParams SeparableBilateral::params(const FrameRun& run) const {
  SeparableBilateralParams params{};
  params.planes = makePlanes(run.frame.size);
  params.stops = makeEdgeStopParams(m_setup.stops);
  params.sigma = static_cast<float>(m_setup.sigma);
  params.alongRows = m_setup.alongRows ? 1 : 0;
  return params;
}

}  // namespace quell

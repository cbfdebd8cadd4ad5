#include "host/stages/firefly_weights.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(FireflyWeightsOptions, FIREFLY_WEIGHTS)

FireflyWeights::FireflyWeights(const Configuration& configuration, double ratio, bool skip) : m_ratio(ratio) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  setSkipOptions<FireflyWeightsOptions>(*this, configuration, skip);
}

FireflyWeightsParams FireflyWeights::params(const FrameRun& run) const {
  FireflyWeightsParams params{};
  params.planes = makePlanes(run.frame.size);
  params.fireflyRatio = static_cast<float>(m_ratio);
  return params;
}

}  // namespace quell

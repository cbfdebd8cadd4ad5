#include "host/stages/accumulate_filtered.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(AccumulateFilteredOptions, ACCUMULATE_FILTERED)

AccumulateFiltered::AccumulateFiltered(const Configuration& configuration, double leastWeight, bool skip)
    : m_leastWeight(leastWeight) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  setSkipOptions<AccumulateFilteredOptions>(*this, configuration, skip);
}

AccumulateFilteredParams AccumulateFiltered::params(const FrameRun& run) const {
  AccumulateFilteredParams params{};
  params.planes = makePlanes(run.frame.size);
  params.leastWeight = static_cast<float>(m_leastWeight);
  return params;
}

}  // namespace quell

#include "host/stages/median_filter.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(MedianFilterOptions, MEDIAN_FILTER)

MedianFilter::MedianFilter(const Configuration& configuration, bool skip) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  setSkipOptions<MedianFilterOptions>(*this, configuration, skip);
}

MedianFilterParams MedianFilter::params(const FrameRun& run) const { return {makePlanes(run.frame.size)}; }

}  // namespace quell

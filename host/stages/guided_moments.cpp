#include "host/stages/guided_moments.hpp"

#include <algorithm>

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(GuidedMomentsOptions, GUIDED_MOMENTS)

GuidedMoments::GuidedMoments(const Configuration& configuration, int subsampling, bool tapWeights,
                             bool skip) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  SUBSAMPLING = subsampling;
  TAP_WEIGHTS = tapWeights ? 1 : 0;
  setCellSizes<GuidedMomentsOptions>(*this, guidedCells(configuration.size(), subsampling));
  setSkipOptions<GuidedMomentsOptions>(*this, configuration, skip);
}

GuidedParams GuidedMoments::params(const FrameRun& run) const {
  return makeGuidedParams(run.frame.size, SUBSAMPLING, 0.0);
}

std::array<std::size_t, 2> GuidedMoments::range(const FrameRun& run) const {
  const int cellsOfItem = std::max(1, run.configuration.device.lanes / SUBSAMPLING);
  return cellItems(guidedCells(run.frame.size, SUBSAMPLING), cellsOfItem);
}

}  // namespace quell

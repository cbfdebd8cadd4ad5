#include "host/stages/weighted_sum.hpp"

// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(WeightedSumOptions, WEIGHTED_SUM)

WeightedSum::WeightedSum(const Configuration& configuration, const FitFeatures& features, int signal,
                         bool skip)
    : m_features(features) {
  setFitOptions<WeightedSumOptions>(*this, configuration, features, signal, skip);
  guidePlanes = (features.needPosition() ? 3 : 0) + 3;  // the normal tells surfaces from background
  recordFloats = fitRecordFloats(configuration.size(), features);
}

FitParams WeightedSum::params(const FrameRun& run) const {
  // The amplitude only matters to the fit: the synthesis uses noise-free features.
  FitParams params = makeFitParams(run.frame.size, run.frameIndex, 0.0);
  params.viewAxis = run.reprojection.viewDepth;
  return params;
}

std::array<std::size_t, 2> WeightedSum::range(const FrameRun& run) const {
  const FitParams grid = params(run);
  const auto itemsPerBlock = QUELL_BLOCK_EDGE / static_cast<std::size_t>(run.configuration.device.lanes);
  return {static_cast<std::size_t>(grid.blocksX) * itemsPerBlock,
          static_cast<std::size_t>(grid.blocksY) * QUELL_BLOCK_EDGE};
}

}  // namespace quell

#include "host/stages/blended_sum.hpp"

#include <algorithm>

#include "host/stages/fit_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(BlendedSumOptions, BLENDED_SUM)

BlendedSum::BlendedSum(const Configuration& configuration, const GramWindows& windows,
                       const FitFeatures& features, int signal, bool skip)
    : m_windows(windows), m_features(features) {
  setFitOptions<BlendedSumOptions>(*this, configuration, features, signal, skip);
  guidePlanes = (features.needPosition() ? 3 : 0) + 3;  // the normal tells surfaces from background
  GRAM_TILE_EDGE = windows.tileEdge;
  recordFloats = gramRecordFloats(windows, configuration.size(), features);
}

GramParams BlendedSum::params(const FrameRun& run) const {
  GramParams params = makeGramParams(m_windows, run.frame.size, run.frameIndex, 0.0);
  params.viewAxis = run.reprojection.viewDepth;
  return params;
}

std::array<std::size_t, 2> BlendedSum::range(const FrameRun& run) const {
  const GramParams grid = params(run);
  const int itemWidth = std::min(run.configuration.device.lanes, m_windows.tileEdge);
  const int itemHeight = run.configuration.device.lanes / itemWidth;
  // One more cell than tiles per axis: cells lie between tile centres.
  const auto items = [&](int tiles, int perItem) {
    return static_cast<std::size_t>((tiles + 1) * m_windows.tileEdge / perItem);
  };
  return {items(grid.tilesX, itemWidth), items(grid.tilesY, itemHeight)};
}

}  // namespace quell

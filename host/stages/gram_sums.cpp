#include "host/stages/gram_sums.hpp"

#include <algorithm>

#include "host/stages/fit_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {
namespace {

// Work-items that share a tile on GPUs: enough for the 91 sums, one each.
constexpr std::size_t kGpuGroup = 128;

}  // namespace

QUELL_PORTS(GramSumsOptions, GRAM_SUMS)

GramSums::GramSums(const Configuration& configuration, const GramWindows& windows,
                   const FitFeatures& features, int signal, bool tapWeights, bool skip)
    : m_windows(windows), m_features(features) {
  setFitOptions<GramSumsOptions>(*this, configuration, features, signal, skip);
  TAP_WEIGHTS = tapWeights ? 1 : 0;
  GRAM_TILE_EDGE = windows.tileEdge;
  GRAM_MIRROR = windows.overlap ? 0 : 1;
  tileFloats = gramTileFloats(windows, configuration.size(), features);
}

void GramSums::build(const KernelBuilder& builder) {
  const Configuration& configuration = builder.configuration();
  // With sixteen lanes a work-item has a tile to itself.
  std::size_t group =
      configuration.device.lanes > 1 ? 1 : builder.groupSize(configuration.options.fitGroup, kGpuGroup);
  // One work-item alone would add up 1024 pixels in one chain, and lose digits.
  if (configuration.device.lanes == 1) group = std::max<std::size_t>(group, 2);
  for (;; group /= 2) {
    GROUP_SIZE = static_cast<int>(group);
    KernelStage::build(builder);
    if (group == 1 || builder.maxWorkGroup(m_kernel) >= group) break;
  }
  m_workGroup = cl::NDRange(group, 1);
}

GramParams GramSums::params(const FrameRun& run) const {
  GramParams params = makeGramParams(m_windows, run.frame.size, run.frameIndex, 0.0);
  params.viewAxis = run.reprojection.viewDepth;
  return params;
}

std::array<std::size_t, 2> GramSums::range(const FrameRun& run) const {
  const GramParams grid = params(run);
  return {static_cast<std::size_t>(grid.tilesX * grid.tilesY) * m_workGroup[0], 1};
}

}  // namespace quell

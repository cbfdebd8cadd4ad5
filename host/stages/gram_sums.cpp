#include "host/stages/gram_sums.hpp"

#include <algorithm>

#include "host/stages/fit.hpp"

namespace quell {
namespace {

// Work-items that share a tile on GPUs: enough for the 91 sums, one each.
constexpr std::size_t kGpuGroup = 128;

}  // namespace

std::string GramSums::label() const { return name() + signalLabel(m_signal); }

void GramSums::build(const KernelBuilder& builder) {
  const Configuration& configuration = builder.configuration();
  // With sixteen lanes a work-item has a tile to itself.
  m_groupSize =
      configuration.device.lanes > 1 ? 1 : builder.groupSize(configuration.options.fitGroup, kGpuGroup);
  // One work-item alone would add up 1024 pixels in one chain, and lose digits.
  if (configuration.device.lanes == 1) m_groupSize = std::max<std::size_t>(m_groupSize, 2);
  for (;; m_groupSize /= 2) {
    m_kernel =
        builder.build("gram_sums", m_features.gramOptions(m_windows.overlap) + signalOptions(m_signal) +
                                       "-D GRAM_GROUP_SIZE=" + std::to_string(m_groupSize) +
                                       " -D GRAM_TILE_EDGE=" + std::to_string(m_windows.tileEdge) +
                                       " -D GRAM_MIRROR=" + (m_windows.overlap ? "0" : "1"));
    if (m_groupSize == 1 || builder.maxWorkGroup(m_kernel) >= m_groupSize) break;
  }
}

void GramSums::enqueue(FrameRun& run) {
  GramParams params = makeGramParams(m_windows, run.configuration.size(), run.frameIndex, 0.0);
  params.viewAxis = run.reprojection.viewDepth;
  const std::size_t tiles = static_cast<std::size_t>(params.tilesX) * static_cast<std::size_t>(params.tilesY);
  run.launch(m_kernel, {tiles * m_groupSize, 1}, cl::NDRange(m_groupSize, 1), run.buffer("irradiance"),
             run.buffer("guides"), materialsOf(run, m_features), run.buffer("gramTiles"), params);
}

}  // namespace quell

#include "host/stages/blended_sum.hpp"

#include <algorithm>

#include "host/stages/fit.hpp"

namespace quell {

std::string BlendedSum::label() const { return name() + signalLabel(m_signal); }

void BlendedSum::build(const KernelBuilder& builder) {
  m_kernel = builder.build("blended_sum", m_features.options() + signalOptions(m_signal) +
                                              "-D GRAM_TILE_EDGE=" + std::to_string(m_windows.tileEdge));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void BlendedSum::enqueue(FrameRun& run) {
  GramParams params = makeGramParams(m_windows, run.configuration.size(), run.frameIndex, 0.0);
  params.viewAxis = run.reprojection.viewDepth;
  const int itemWidth = std::min(run.configuration.device.lanes, m_windows.tileEdge);
  const int itemHeight = run.configuration.device.lanes / itemWidth;
  // One more cell than tiles per axis: cells lie between tile centres.
  const auto items = [&](int tiles, int perItem) {
    return static_cast<std::size_t>((tiles + 1) * m_windows.tileEdge / perItem);
  };
  run.launch(m_kernel, {items(params.tilesX, itemWidth), items(params.tilesY, itemHeight)}, m_workGroup,
             run.buffer("fitRecords"), run.buffer("guides"), materialsOf(run, m_features),
             run.buffer("fitted"), params);
}

}  // namespace quell

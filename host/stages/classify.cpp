#include "host/stages/classify.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

std::array<int, 2> tileGrid(Size size) {
  return {(size.width + QUELL_TILE_WIDTH - 1) / QUELL_TILE_WIDTH,
          (size.height + QUELL_TILE_HEIGHT - 1) / QUELL_TILE_HEIGHT};
}

void Classify::build(const KernelBuilder& builder) {
  const int signals = signalCount(builder.configuration().frame);
  m_kernel = builder.build("classify", "-D QUELL_SIGNALS=" + std::to_string(signals));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void Classify::enqueue(FrameRun& run) {
  const std::array<int, 2> grid = tileGrid(run.configuration.size());
  ClassifyParams params{};
  params.planes = makePlanes(run.configuration.size());
  params.tilesX = grid[0];
  params.tilesY = grid[1];
  params.iterations = m_iterations;
  params.tolerance = static_cast<float>(m_tolerance);
  run.launch(m_kernel, {static_cast<std::size_t>(grid[0]), static_cast<std::size_t>(grid[1])}, m_workGroup,
             run.buffer("variance"), run.buffer("moments"), run.buffer("tileLevels"), params);
}

}  // namespace quell

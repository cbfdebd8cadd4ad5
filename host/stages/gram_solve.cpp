#include "host/stages/gram_solve.hpp"

#include <algorithm>

namespace quell {
namespace {

// Windows are independent and there are few of them: small groups spread them over all compute units.
constexpr std::size_t kGpuGroup = 64;

}  // namespace

void GramSolve::build(const KernelBuilder& builder) {
  m_kernel = builder.build("gram_solve", m_features.gramOptions(m_windows.overlap) +
                                             "-D GRAM_OVERLAP=" + (m_windows.overlap ? "1" : "0"));
  m_groupSize =
      builder.configuration().device.lanes > 1 ? 1 : std::min(kGpuGroup, builder.maxWorkGroup(m_kernel));
}

void GramSolve::enqueue(FrameRun& run) {
  const GramParams params =
      makeGramParams(m_windows, run.configuration.size(), run.frameIndex, m_noiseAmplitude);
  const std::size_t lanes = static_cast<std::size_t>(run.configuration.device.lanes);
  const std::size_t windows =
      static_cast<std::size_t>(params.tilesX) * static_cast<std::size_t>(params.tilesY);
  run.launch(m_kernel, {(windows + lanes - 1) / lanes, 1}, cl::NDRange(m_groupSize, 1),
             run.buffer("gramTiles"), run.buffer("fitRecords"), params);
}

}  // namespace quell

#include "host/stages/weighted_sum.hpp"

#include "host/stages/fit.hpp"

namespace quell {

std::string WeightedSum::label() const { return name() + signalLabel(m_signal); }

void WeightedSum::build(const KernelBuilder& builder) {
  m_kernel = builder.build("weighted_sum", m_features.options() + signalOptions(m_signal));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void WeightedSum::enqueue(FrameRun& run) {
  // The amplitude only matters to the fit: the synthesis uses noise-free features.
  FitParams params = makeFitParams(run.configuration.size(), run.frameIndex, 0.0);
  params.viewAxis = run.reprojection.viewDepth;
  const std::size_t itemsPerBlock =
      QUELL_BLOCK_EDGE / static_cast<std::size_t>(run.configuration.device.lanes);
  const std::array<std::size_t, 2> range = {static_cast<std::size_t>(params.blocksX) * itemsPerBlock,
                                            static_cast<std::size_t>(params.blocksY) * QUELL_BLOCK_EDGE};
  run.launch(m_kernel, range, m_workGroup, run.buffer("fitRecords"), run.buffer("guides"),
             materialsOf(run, m_features), run.buffer("fitted"), params);
}

std::uint64_t WeightedSum::callerBytes(const Configuration&) const { return 0; }

}  // namespace quell

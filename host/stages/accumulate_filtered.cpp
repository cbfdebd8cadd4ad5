#include "host/stages/accumulate_filtered.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void AccumulateFiltered::build(const KernelBuilder& builder) {
  m_kernel = builder.build("accumulate_filtered",
                           "-D QUELL_SIGNALS=" + std::to_string(signalCount(builder.configuration().frame)));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void AccumulateFiltered::enqueue(FrameRun& run) {
  AccumulateFilteredParams params{};
  params.planes = makePlanes(run.configuration.size());
  params.leastWeight = static_cast<float>(m_leastWeight);
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.buffer("fitted"), run.buffer("filtered.prev"),
             run.buffer("pixelPrev"), run.buffer("reprojectionMask"), run.buffer("historyLength"),
             run.buffer("filtered"), params);
}

std::uint64_t AccumulateFiltered::callerBytes(const Configuration&) const { return 0; }

}  // namespace quell

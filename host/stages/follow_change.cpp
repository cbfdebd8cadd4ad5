#include "host/stages/follow_change.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void FollowChange::build(const KernelBuilder& builder) {
  const int signals = signalCount(builder.configuration().frame);
  m_kernel =
      builder.build("follow_change", "-D QUELL_SIGNALS=" + std::to_string(signals) + skipOption(m_skip));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void FollowChange::enqueue(FrameRun& run) {
  ChangeParams params = makeChangeParams(m_detection, run.configuration.size());
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.buffer("changeWeights"),
             run.buffer("newestIrradiance"), run.buffer("irradiance"), run.buffer("moments"),
             run.buffer("historyLength"), m_skip ? run.buffer(kSurfacesBuffer) : cl::Buffer(), params);
}

}  // namespace quell

#include "host/stages/change_weight.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void ChangeWeight::build(const KernelBuilder& builder) {
  const int signals = signalCount(builder.configuration().frame);
  m_kernel = builder.build("change_weight", "-D QUELL_SIGNALS=" + std::to_string(signals));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void ChangeWeight::enqueue(FrameRun& run) {
  ChangeParams params = makeChangeParams(m_detection, run.configuration.size());
  params.restarted = run.frameIndex == 0 ? 1 : 0;
  run.launch(m_kernel, tileRange(params), m_workGroup, run.buffer("changeSums"),
             run.buffer("recentChange.prev"), run.buffer("recentChange"), run.buffer("changeWeights"),
             params);
}

}  // namespace quell

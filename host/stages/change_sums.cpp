#include "host/stages/change_sums.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void ChangeSums::build(const KernelBuilder& builder) {
  const int signals = signalCount(builder.configuration().frame);
  m_kernel = builder.build("change_sums", "-D QUELL_SIGNALS=" + std::to_string(signals));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void ChangeSums::enqueue(FrameRun& run) {
  ChangeParams params = makeChangeParams(m_detection, run.configuration.size());
  // A restarted history has no sums.
  if (run.frameIndex == 0) params.sumsKept = 0.0f;
  run.launch(m_kernel, tileRange(params), m_workGroup, run.buffer("innovation"), run.buffer("historyLength"),
             run.buffer("changeSums.prev"), run.buffer("changeSums"), params);
}

}  // namespace quell

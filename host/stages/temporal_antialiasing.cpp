#include "host/stages/temporal_antialiasing.hpp"

namespace quell {

void TemporalAntialiasing::build(const KernelBuilder& builder) {
  m_kernel =
      builder.build("temporal_antialiasing", layoutOptions("OUTPUT", builder.configuration().output.display));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void TemporalAntialiasing::enqueue(FrameRun& run) {
  TemporalAntialiasingParams params{};
  params.planes = makePlanes(run.configuration.size());
  params.output = makeViewParams(run.output.display, run.configuration.size());
  params.newestWeight = static_cast<float>(m_newestWeight);
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.buffer("encoded"), run.buffer("antialiased.prev"),
             run.buffer("pixelPrev"), run.buffer("reprojectionMask"), run.buffer("antialiased"),
             run.output.display, params);
}

std::uint64_t TemporalAntialiasing::callerBytes(const Configuration& configuration) const {
  return imageBytes(configuration.output.display, configuration.size());
}

}  // namespace quell

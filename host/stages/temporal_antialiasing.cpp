#include "host/stages/temporal_antialiasing.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void TemporalAntialiasing::build(const KernelBuilder& builder) {
  m_kernel =
      builder.build("temporal_antialiasing",
                    layoutOptions("OUTPUT", builder.configuration().output.display) + skipOption(m_skip));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void TemporalAntialiasing::enqueue(FrameRun& run) {
  TemporalAntialiasingParams params{};
  params.planes = makePlanes(run.configuration.size());
  params.output = makeViewParams(run.output.display, run.configuration.size());
  params.newestWeight = static_cast<float>(m_newestWeight);
  params.jitters = isJittered(run.frame.camera) ? 1 : 0;
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.buffer("encoded"), run.buffer("antialiased.prev"),
             run.buffer("pixelPrev"), run.buffer("reprojectionMask"), run.buffer("antialiased"),
             run.output.display, m_skip ? run.buffer(kSurfacesBuffer) : cl::Buffer(), params);
}

std::uint64_t TemporalAntialiasing::callerBytes(const Configuration& configuration) const {
  return imageBytes(configuration.output.display, configuration.size());
}

}  // namespace quell

#include "host/stages/variance.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void Variance::build(const KernelBuilder& builder) {
  const int signals = signalCount(builder.configuration().frame);
  m_kernel =
      builder.build("variance", "-D QUELL_SIGNALS=" + std::to_string(signals) + " -D ROUGHNESS_FORMAT=0" +
                                    " -D OF_MEAN=" + (m_setup.ofMean ? "1" : "0") + skipOption(m_setup.skip));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void Variance::enqueue(FrameRun& run) {
  VarianceParams params{};
  params.planes = makePlanes(run.configuration.size());
  params.stops = makeEdgeStopParams(m_setup.stops);
  params.temporalFrames = m_setup.temporalFrames;
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.buffer("moments"), run.buffer("historyLength"),
             run.buffer("guides"), run.buffer("viewDepth"), run.buffer("variance"),
             m_setup.skip ? run.buffer(kSurfacesBuffer) : cl::Buffer(), params);
}

}  // namespace quell

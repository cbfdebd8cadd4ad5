#include "host/stages/variance.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void Variance::build(const KernelBuilder& builder) {
  const int signals = signalCount(builder.configuration().frame);
  m_kernel =
      builder.build("variance", "-D QUELL_SIGNALS=" + std::to_string(signals) + " -D ROUGHNESS_FORMAT=0" +
                                    " -D OF_MEAN=" + (m_setup.leastWeight > 0.0 ? "1" : "0"));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void Variance::enqueue(FrameRun& run) {
  VarianceParams params{};
  params.planes = makePlanes(run.configuration.size());
  params.stops = makeEdgeStopParams(m_setup.stops);
  params.temporalFrames = m_setup.temporalFrames;
  // Samples that an exponential mean is worth: (2 - weight) / weight.
  if (m_setup.leastWeight > 0.0) params.mostSamples = static_cast<float>(2.0 / m_setup.leastWeight - 1.0);
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.buffer("moments"), run.buffer("historyLength"),
             run.buffer("guides"), run.buffer("viewDepth"), run.buffer("variance"), params);
}

}  // namespace quell

#include "host/stages/atrous.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void Atrous::build(const KernelBuilder& builder) {
  const Frame& frame = builder.configuration().frame;
  m_kernel = builder.build("atrous", "-D QUELL_SIGNALS=" + std::to_string(signalCount(frame)) +
                                         " -D VARIANCE=" + (m_setup.variance.empty() ? "0" : "1") +
                                         " -D ROUGHNESS_FORMAT=" + (readsRoughness(frame) ? "1" : "0") +
                                         " -D FILTER_VARIANCE=" + (m_setup.varianceOut.empty() ? "0" : "1") +
                                         " -D TAP_RADIUS=" + std::to_string(m_setup.radius) +
                                         " -D TAP_CORNERS=" + (m_setup.corners ? "1" : "0") +
                                         skipOption(m_setup.skip));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void Atrous::enqueue(FrameRun& run) {
  const auto bufferIf = [&](bool wanted, const std::string& name) {
    return wanted ? run.buffer(name) : cl::Buffer();
  };
  const bool variance = !m_setup.variance.empty();
  AtrousParams params{};
  params.planes = makePlanes(run.configuration.size());
  params.stops = makeEdgeStopParams(m_setup.stops);
  params.luminanceSigma = static_cast<float>(m_setup.luminanceSigma);
  params.inverseStep = 1.0f / static_cast<float>(m_setup.step);
  params.step = m_setup.step;
  params.iteration = m_setup.iteration;
  if (m_setup.sharpRoughness > 0.0) {
    params.sharpening = 1.0f;
    params.inverseSharpRoughness = static_cast<float>(1.0 / m_setup.sharpRoughness);
  }
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.buffer(m_setup.input),
             bufferIf(variance, m_setup.variance), run.buffer("guides"), run.buffer("viewDepth"),
             bufferIf(readsRoughness(run.configuration.frame), "roughness"), run.buffer(m_setup.output),
             bufferIf(!m_setup.varianceOut.empty(), m_setup.varianceOut),
             bufferIf(m_setup.skip, kSurfacesBuffer), params);
}

}  // namespace quell

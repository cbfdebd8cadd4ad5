#include "host/stages/remodulate.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void Remodulate::build(const KernelBuilder& builder) {
  const Configuration& configuration = builder.configuration();
  m_kernel = builder.build("remodulate", materialOptions(configuration.frame) +
                                             layoutOptions("OUTPUT", configuration.output.linear) +
                                             " -D WRITE_PLANES=" + (m_writePlanes ? "1" : "0"));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void Remodulate::enqueue(FrameRun& run) {
  const Size size = run.configuration.size();
  RemodulateParams params{};
  params.planes = makePlanes(size);
  params.radiance = makeViewParams(run.frame.radiance, size);
  params.emission = makeViewParams(run.frame.emission, size);
  params.albedo = makeViewParams(run.frame.albedo, size);
  params.glossColor = makeViewParams(run.frame.glossColor, size);
  params.output = makeViewParams(run.output.linear, size);
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.buffer("filtered"), run.buffer("guides"),
             run.frame.radiance, run.frame.emission, run.frame.albedo, run.frame.glossColor,
             m_writePlanes ? run.buffer("linear") : cl::Buffer(), run.output.linear, params);
}

std::uint64_t Remodulate::callerBytes(const Configuration& configuration) const {
  return materialBytes(configuration.frame) + imageBytes(configuration.output.linear, configuration.size());
}

}  // namespace quell

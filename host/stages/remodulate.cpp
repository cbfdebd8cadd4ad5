#include "host/stages/remodulate.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void Remodulate::build(const KernelBuilder& builder) {
  const Configuration& configuration = builder.configuration();
  m_kernel =
      builder.build("remodulate", materialOptions(configuration) +
                                      layoutOptions("LINEAROUTPUT", configuration.output.linear) +
                                      layoutOptions("DISPLAYOUTPUT", displayOutput(configuration.output)) +
                                      " -D WRITE_PLANES=" + (m_writePlanes ? "1" : "0") + skipOption(m_skip));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void Remodulate::enqueue(FrameRun& run) {
  const Frame& frame = run.frame;
  RemodulateParams params{};
  params.planes = makePlanes(frame.size);
  params.material = makeMaterialParams(frame, run.reprojection);
  params.linearOutput = makeViewParams(run.output.linear, frame.size);
  params.displayOutput = makeViewParams(displayOutput(run.output), frame.size);
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.buffer(m_filtered), run.buffer("guides"),
             dividesByFBeta(run.configuration) ? run.buffer("fBeta") : cl::Buffer(), frame.radiance,
             frame.glossyRadiance, frame.emission, frame.albedo, frame.glossColor,
             m_writePlanes ? run.buffer("encoded") : cl::Buffer(), run.output.linear,
             displayOutput(run.output), m_skip ? run.buffer(kSurfacesBuffer) : cl::Buffer(), params);
}

std::uint64_t Remodulate::callerBytes(const Configuration& configuration) const {
  return materialBytes(configuration.frame) + imageBytes(configuration.output.linear, configuration.size()) +
         imageBytes(displayOutput(configuration.output), configuration.size());
}

}  // namespace quell

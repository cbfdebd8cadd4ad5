#include "host/stages/background.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void Background::build(const KernelBuilder& builder) {
  const Configuration& configuration = builder.configuration();
  m_kernel = builder.build("background", materialOptions(configuration) +
                                             layoutOptions("LINEAROUTPUT", configuration.output.linear) +
                                             layoutOptions("DISPLAYOUTPUT", configuration.output.display) +
                                             " -D ANTIALIAS=" + (m_antialias ? "1" : "0"));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void Background::enqueue(FrameRun& run) {
  const Frame& frame = run.frame;
  BackgroundParams params{};
  params.planes = makePlanes(frame.size);
  params.material = makeMaterialParams(frame, run.reprojection);
  params.linearOutput = makeViewParams(run.output.linear, frame.size);
  params.displayOutput = makeViewParams(run.output.display, frame.size);
  params.finish = m_antialias && isJittered(frame.camera) ? 0 : 1;
  const auto bufferIf = [&](const char* name) { return m_antialias ? run.buffer(name) : cl::Buffer(); };
  run.launch(m_kernel, run.pixelRange(), m_workGroup, frame.radiance, frame.glossyRadiance, frame.emission,
             frame.albedo, frame.glossColor, run.buffer(kSurfacesBuffer), bufferIf("encoded"),
             bufferIf("antialiased"), run.output.linear, run.output.display, params);
}

// Only background is read and written; as many bytes as there would be if all of the frame were.
std::uint64_t Background::callerBytes(const Configuration& configuration) const {
  return materialBytes(configuration.frame) + imageBytes(configuration.output.linear, configuration.size()) +
         imageBytes(configuration.output.display, configuration.size());
}

}  // namespace quell

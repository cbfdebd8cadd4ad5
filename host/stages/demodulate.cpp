#include "host/stages/demodulate.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void Demodulate::build(const KernelBuilder& builder) {
  const Configuration& configuration = builder.configuration();
  m_kernel =
      builder.build("demodulate", materialOptions(configuration) + surfaceOptions(configuration.frame));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void Demodulate::enqueue(FrameRun& run) {
  const Frame& frame = run.frame;
  DemodulateParams params{};
  params.reprojection = run.reprojection;
  params.planes = makePlanes(frame.size);
  params.material = makeMaterialParams(frame, run.reprojection);
  params.surface = makeSurfaceParams(frame);
  run.launch(m_kernel, run.pixelRange(), m_workGroup, frame.radiance, frame.glossyRadiance, frame.emission,
             frame.albedo, frame.glossColor, frame.roughness, frame.f0, run.configuration.fBetaTable,
             frame.normalWorld, positionView(frame), run.buffer("irradiance"), run.buffer("guides"),
             run.buffer("viewDepth"), frame.roughness.present() ? run.buffer("roughness") : cl::Buffer(),
             dividesByFBeta(run.configuration) ? run.buffer("fBeta") : cl::Buffer(), params);
}

std::uint64_t Demodulate::callerBytes(const Configuration& configuration) const {
  const Frame& frame = configuration.frame;
  return materialBytes(frame) + fBetaBytes(configuration) + imageBytes(frame.normalWorld, frame.size) +
         imageBytes(positionView(frame), frame.size) + imageBytes(frame.roughness, frame.size);
}

}  // namespace quell

#include "host/stages/accumulate_noisy.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void AccumulateNoisy::build(const KernelBuilder& builder) {
  const Configuration& configuration = builder.configuration();
  m_kernel =
      builder.build("accumulate_noisy",
                    materialOptions(configuration) + surfaceOptions(configuration.frame) +
                        motionOptions(configuration.frame) + " -D MOMENTS=" + (hasMoments() ? "1" : "0") +
                        " -D FILTER_GUIDES=" + (m_setup.filterGuides ? "1" : "0") +
                        " -D INNOVATION=" + (m_setup.innovation ? "1" : "0") + skipOption(m_setup.skip));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void AccumulateNoisy::enqueue(FrameRun& run) {
  const Frame& frame = run.frame;
  const bool roughness = m_setup.filterGuides && frame.roughness.present();
  const auto bufferIf = [&](bool wanted, const char* name) {
    return wanted ? run.buffer(name) : cl::Buffer();
  };
  AccumulateNoisyParams params{};
  params.reprojection = run.reprojection;
  params.planes = makePlanes(frame.size);
  params.material = makeMaterialParams(frame, run.reprojection);
  params.surface = makeSurfaceParams(frame);
  params.motion = makeMotionParams(frame);
  params.leastWeight = static_cast<float>(m_setup.leastWeight);
  params.mostFrames = m_setup.mostFrames;
  params.mostFramesStill = m_setup.mostFramesStill;
  params.jitters = isJittered(frame.camera) ? 1 : 0;
  params.momentsLeastWeight = static_cast<float>(m_setup.momentsLeastWeight);
  const bool objectIds = frame.objectId.present();
  run.launch(m_kernel, run.pixelRange(), m_workGroup, frame.radiance, frame.glossyRadiance, frame.emission,
             frame.albedo, frame.glossColor, frame.roughness, frame.f0, run.configuration.fBetaTable,
             frame.normalWorld, positionView(frame), frame.motion, frame.objectId,
             run.buffer(m_setup.irradiancePrev), run.buffer("historyLength.prev"), run.buffer("guides.prev"),
             bufferIf(hasMoments(), "moments.prev"), bufferIf(objectIds, "objectIds.prev"),
             run.buffer("irradiance"), run.buffer("historyLength"), run.buffer("guides"),
             bufferIf(hasMoments(), "moments"), bufferIf(objectIds, "objectIds"), run.buffer("pixelPrev"),
             run.buffer("reprojectionMask"), bufferIf(m_setup.filterGuides, "viewDepth"),
             bufferIf(roughness, "roughness"), bufferIf(dividesByFBeta(run.configuration), "fBeta"),
             bufferIf(m_setup.innovation, "newestIrradiance"), bufferIf(m_setup.innovation, "innovation"),
             bufferIf(m_setup.skip, kSurfacesBuffer), params);
}

std::uint64_t AccumulateNoisy::callerBytes(const Configuration& configuration) const {
  const Frame& frame = configuration.frame;
  return materialBytes(frame) + fBetaBytes(configuration) + imageBytes(frame.normalWorld, frame.size) +
         imageBytes(positionView(frame), frame.size) + motionBytes(frame) +
         (m_setup.filterGuides ? imageBytes(frame.roughness, frame.size) : 0);
}

}  // namespace quell

#include "host/stages/accumulate_noisy.hpp"

#include "host/core/frame_images.hpp"

namespace quell {

void AccumulateNoisy::build(const KernelBuilder& builder) {
  const Frame& frame = builder.configuration().frame;
  m_kernel = builder.build("accumulate_noisy", materialOptions(frame) + surfaceOptions(frame));
  m_workGroup = builder.pixelWorkGroup(m_kernel);
}

void AccumulateNoisy::enqueue(FrameRun& run) {
  const Size size = run.configuration.size();
  const ImageView& position = positionView(run.frame);
  AccumulateNoisyParams params{};
  params.reprojection = run.reprojection;
  params.planes = makePlanes(size);
  params.radiance = makeViewParams(run.frame.radiance, size);
  params.emission = makeViewParams(run.frame.emission, size);
  params.albedo = makeViewParams(run.frame.albedo, size);
  params.glossColor = makeViewParams(run.frame.glossColor, size);
  params.normal = makeViewParams(run.frame.normalWorld, size);
  params.position = makeViewParams(position, size);
  params.leastWeight = static_cast<float>(m_leastWeight);
  run.launch(m_kernel, run.pixelRange(), m_workGroup, run.frame.radiance, run.frame.emission,
             run.frame.albedo, run.frame.glossColor, run.frame.normalWorld, position,
             run.buffer("irradiance.prev"), run.buffer("historyLength.prev"), run.buffer("guides.prev"),
             run.buffer("irradiance"), run.buffer("historyLength"), run.buffer("guides"),
             run.buffer("pixelPrev"), run.buffer("reprojectionMask"), params);
}

std::uint64_t AccumulateNoisy::callerBytes(const Configuration& configuration) const {
  const Frame& frame = configuration.frame;
  return materialBytes(frame) + imageBytes(frame.normalWorld, frame.size) +
         imageBytes(positionView(frame), frame.size);
}

}  // namespace quell

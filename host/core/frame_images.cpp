#include "host/core/frame_images.hpp"

#include <quell/error.hpp>

namespace quell {

bool dividesByFBeta(const Configuration& configuration) {
  if (configuration.runtime.demodulation != Demodulation::FBeta) return false;
  if (!configuration.frame.roughness.present())
    throw Error(ErrorCode::InvalidArgument,
                {"prepare", "roughness", "an image, since light is divided by F_beta", "none"});
  return true;
}

std::string materialOptions(const Configuration& configuration) {
  const Frame& frame = configuration.frame;
  return layoutOptions("RADIANCE", frame.radiance) + layoutOptions("GLOSSYRADIANCE", frame.glossyRadiance) +
         layoutOptions("EMISSION", frame.emission) + layoutOptions("ALBEDO", frame.albedo) +
         layoutOptions("GLOSSCOLOR", frame.glossColor) + layoutOptions("ROUGHNESS", frame.roughness) +
         layoutOptions("F0", frame.f0) + " -D QUELL_SIGNALS=" + std::to_string(signalCount(frame)) +
         (frame.demodulated ? " -D DEMODULATED=1" : " -D DEMODULATED=0") +
         " -D DEMODULATE=" + std::to_string(static_cast<int>(configuration.runtime.demodulation));
}

MaterialParams makeMaterialParams(const Frame& frame, const ReprojectionParams& reprojection) {
  MaterialParams params{};
  const QuellFloat4& w = reprojection.clipW;
  params.viewAxis = reprojection.viewDepth;
  params.viewAxis.w = w.x == 0.0f && w.y == 0.0f && w.z == 0.0f ? 1.0f : 0.0f;
  params.radiance = makeViewParams(frame.radiance, frame.size);
  params.glossyRadiance = makeViewParams(frame.glossyRadiance, frame.size);
  params.emission = makeViewParams(frame.emission, frame.size);
  params.albedo = makeViewParams(frame.albedo, frame.size);
  params.glossColor = makeViewParams(frame.glossColor, frame.size);
  params.roughness = makeViewParams(frame.roughness, frame.size);
  params.f0 = makeViewParams(frame.f0, frame.size);
  return params;
}

std::uint64_t materialBytes(const Frame& frame) {
  return imageBytes(frame.radiance, frame.size) + imageBytes(frame.glossyRadiance, frame.size) +
         imageBytes(frame.emission, frame.size) + imageBytes(frame.albedo, frame.size) +
         imageBytes(frame.glossColor, frame.size);
}

std::uint64_t fBetaBytes(const Configuration& configuration) {
  if (!dividesByFBeta(configuration)) return 0;
  const Frame& frame = configuration.frame;
  return imageBytes(frame.roughness, frame.size) + imageBytes(frame.f0, frame.size);
}

std::string surfaceOptions(const Frame& frame) {
  return layoutOptions("NORMAL", frame.normalWorld) + layoutOptions("POSITION", positionView(frame)) +
         (frame.positionWorld.present() ? " -D POSITION_IS_DEPTH=0" : " -D POSITION_IS_DEPTH=1");
}

SurfaceParams makeSurfaceParams(const Frame& frame) {
  SurfaceParams params{};
  params.normal = makeViewParams(frame.normalWorld, frame.size);
  params.position = makeViewParams(positionView(frame), frame.size);
  return params;
}

bool isJittered(const Camera& camera) {
  const std::array<double, 2> centred{0.0, 0.0};
  return camera.jitterPx != centred || camera.jitterPxPrev != centred;
}

std::string motionOptions(const Frame& frame) {
  return layoutOptions("MOTION", frame.motion) + layoutOptions("OBJECTID", frame.objectId);
}

MotionParams makeMotionParams(const Frame& frame) {
  MotionParams params{};
  params.motion = makeViewParams(frame.motion, frame.size);
  params.objectId = makeViewParams(frame.objectId, frame.size);
  return params;
}

std::uint64_t motionBytes(const Frame& frame) {
  return imageBytes(frame.motion, frame.size) + imageBytes(frame.objectId, frame.size);
}

}  // namespace quell

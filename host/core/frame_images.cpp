#include "host/core/frame_images.hpp"

namespace quell {

std::string materialOptions(const Configuration& configuration) {
  const Frame& frame = configuration.frame;
  return layoutOptions("RADIANCE", frame.radiance) + layoutOptions("GLOSSYRADIANCE", frame.glossyRadiance) +
         layoutOptions("EMISSION", frame.emission) + layoutOptions("ALBEDO", frame.albedo) +
         layoutOptions("GLOSSCOLOR", frame.glossColor) +
         " -D QUELL_SIGNALS=" + std::to_string(signalCount(frame)) +
         (frame.demodulated ? " -D DEMODULATED=1" : " -D DEMODULATED=0") +
         (configuration.settings.text("demodulate") == "none" ? " -D DEMODULATE=0" : " -D DEMODULATE=1");
}

MaterialParams makeMaterialParams(const Frame& frame) {
  MaterialParams params{};
  params.radiance = makeViewParams(frame.radiance, frame.size);
  params.glossyRadiance = makeViewParams(frame.glossyRadiance, frame.size);
  params.emission = makeViewParams(frame.emission, frame.size);
  params.albedo = makeViewParams(frame.albedo, frame.size);
  params.glossColor = makeViewParams(frame.glossColor, frame.size);
  return params;
}

std::uint64_t materialBytes(const Frame& frame) {
  return imageBytes(frame.radiance, frame.size) + imageBytes(frame.glossyRadiance, frame.size) +
         imageBytes(frame.emission, frame.size) + imageBytes(frame.albedo, frame.size) +
         imageBytes(frame.glossColor, frame.size);
}

std::string surfaceOptions(const Frame& frame) {
  return layoutOptions("NORMAL", frame.normalWorld) + layoutOptions("POSITION", positionView(frame)) +
         layoutOptions("ROUGHNESS", frame.roughness) +
         (frame.positionWorld.present() ? " -D POSITION_IS_DEPTH=0" : " -D POSITION_IS_DEPTH=1");
}

SurfaceParams makeSurfaceParams(const Frame& frame) {
  SurfaceParams params{};
  params.normal = makeViewParams(frame.normalWorld, frame.size);
  params.position = makeViewParams(positionView(frame), frame.size);
  params.roughness = makeViewParams(frame.roughness, frame.size);
  return params;
}

}  // namespace quell

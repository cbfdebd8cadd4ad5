// The caller's images as groups that several stages read.
#pragma once

#include <quell/frame.hpp>
#include <string>

#include "host/core/stage.hpp"

namespace quell {

/// World position, or view depth where that is given instead.
inline const ImageView& positionView(const Frame& frame) {
  return frame.positionWorld.present() ? frame.positionWorld : frame.viewDepth;
}

/// Compile options for radiance and what it is divided by.
inline std::string materialOptions(const Frame& frame) {
  return layoutOptions("RADIANCE", frame.radiance) + layoutOptions("EMISSION", frame.emission) +
         layoutOptions("ALBEDO", frame.albedo) + layoutOptions("GLOSSCOLOR", frame.glossColor) +
         (frame.demodulated ? " -D DEMODULATED=1" : " -D DEMODULATED=0");
}

/// Compile options for normal and position.
inline std::string surfaceOptions(const Frame& frame) {
  return layoutOptions("NORMAL", frame.normalWorld) + layoutOptions("POSITION", positionView(frame)) +
         (frame.positionWorld.present() ? " -D POSITION_IS_DEPTH=0" : " -D POSITION_IS_DEPTH=1");
}

/// Bytes of radiance and what it is divided by.
inline std::uint64_t materialBytes(const Frame& frame) {
  return imageBytes(frame.radiance, frame.size) + imageBytes(frame.emission, frame.size) +
         imageBytes(frame.albedo, frame.size) + imageBytes(frame.glossColor, frame.size);
}

}  // namespace quell

// Compile options and parameters that several stages have.
#pragma once

#include <cmath>

#include "host/core/frame_images.hpp"

namespace quell {

/// Sets QUELL_SIGNALS, DEMODULATED and DEMODULATE; `options` is a struct of QUELL_OPTIONS.
template <class Options>
void setLightOptions(Options& options, const Configuration& configuration) {
  options.QUELL_SIGNALS = signalCount(configuration.frame);
  options.DEMODULATED = configuration.frame.demodulated ? 1 : 0;
  options.DEMODULATE = static_cast<int>(configuration.runtime.demodulation);
}

/// Sets SKIP and surfaceItems: whether the stage leaves out background, or finds it; see kernels/common/surfaces.h.
template <class Options>
void setSkipOptions(Options& options, const Configuration& configuration, bool skip) {
  options.SKIP = skip ? 1 : 0;
  options.surfaceItems = surfaceItemCount(configuration);
}

/// Sets TONE_MAP and DISPLAY_ENCODING.
template <class Options>
void setDisplayOptions(Options& options, const Configuration& configuration) {
  options.TONE_MAP = static_cast<int>(configuration.runtime.display.toneMap);
  options.DISPLAY_ENCODING = static_cast<int>(configuration.runtime.display.encoding);
}

/// Factor of radiance in the display image.
inline float exposureFactor(const Configuration& configuration) {
  return static_cast<float>(std::exp2(configuration.runtime.display.exposure));
}

}  // namespace quell

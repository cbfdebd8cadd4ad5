// Compile options of the stages that read light and what it is divided by.
#pragma once

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

}  // namespace quell

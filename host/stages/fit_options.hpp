// Options and sizes of the stages that work on one signal with the features of a fit.
#pragma once

#include "host/stages/fit_features.hpp"
#include "host/stages/stage_options.hpp"
#include "kernels/fit_params.h"

namespace quell {

/// What such a stage's label ends with: nothing for the first signal.
inline std::string signalLabel(int signal) {
  return signal == 0 ? "" : " (signal " + std::to_string(signal + 1) + ")";
}

/// Sets everything that these stages have in common; `options` is a struct of QUELL_OPTIONS.
template <class Options>
void setFitOptions(Options& options, const Configuration& configuration, const FitFeatures& features,
                   int signal, bool skip) {
  options.QUELL_SIGNALS = signalCount(configuration.frame);
  options.QUELL_SIGNAL = signal;
  options.QUELL_USES_MATERIAL = features.needMaterial() ? 1 : 0;
  options.guidePlanes = (features.needPosition() ? 3 : 0) + (features.needNormal() ? 3 : 0);
  options.materialPlanes = (features.needAlbedo() ? 3 : 0) + (features.needRoughness() ? 1 : 0);
  setSkipOptions(options, configuration, skip);
}

}  // namespace quell

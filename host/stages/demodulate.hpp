// Host side of the stage demodulate.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/demodulate_ports.h"

namespace quell {

QUELL_OPTIONS(DemodulateOptions, DEMODULATE, "demodulate")

/// See kernels/demodulate.cl for what it computes, from what and after which paper.
class Demodulate : public KernelStage<DemodulateOptions, DemodulateParams> {
 public:
  /// `skip`: finds the background; see kernels/common/surfaces.h.
  Demodulate(const Configuration& configuration, bool skip);

 protected:
  DemodulateParams params(const FrameRun& run) const override;
};

}  // namespace quell

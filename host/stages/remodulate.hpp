// Host side of the stage remodulate.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/remodulate_ports.h"

namespace quell {

QUELL_OPTIONS(RemodulateOptions, REMODULATE, "remodulate")

/// See kernels/remodulate.cl for what it computes, from what and after which paper.
class Remodulate : public KernelStage<RemodulateOptions, RemodulateParams> {
 public:
  struct Setup {
    bool antialias = false;        ///< temporal_antialiasing follows and writes the display image
    bool antialiasLinear = false;  ///< and the linear one
    bool keepLight = false;        ///< light_gain has gone before
    bool skip = false;             ///< leaves background to the stage background
  };
  Remodulate(const Configuration& configuration, const Setup& setup);

 protected:
  RemodulateParams params(const FrameRun& run) const override;
};

}  // namespace quell

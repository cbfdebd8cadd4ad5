// Host side of the stage background.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/background_ports.h"

namespace quell {

QUELL_OPTIONS(BackgroundOptions, BACKGROUND, "background")

/// See kernels/background.cl for what it computes, from what and after which paper.
class Background : public KernelStage<BackgroundOptions, BackgroundParams> {
 public:
  struct Setup {
    bool antialias = false;            ///< temporal_antialiasing follows
    bool antialiasBackground = false;  ///< background takes part in it whatever the camera's jitter
    bool antialiasLinear = false;      ///< it writes the linear image, too
  };
  Background(const Configuration& configuration, const Setup& setup);
  Coverage coverage(const Frame&) const override { return Coverage::Background; }

 protected:
  BackgroundParams params(const FrameRun& run) const override;
};

}  // namespace quell

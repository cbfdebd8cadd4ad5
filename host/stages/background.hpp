// Host side of the stage background.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/background_ports.h"

namespace quell {

QUELL_OPTIONS(BackgroundOptions, BACKGROUND, "background")

/// See kernels/background.cl for what it computes, from what and after which paper.
class Background : public KernelStage<BackgroundOptions, BackgroundParams> {
 public:
  /// `antialias`: whether temporal_antialiasing follows; `antialiasBackground`: whether background takes part in it even
  /// if rays are not jittered.
  Background(const Configuration& configuration, bool antialias, bool antialiasBackground);
  Coverage coverage(const Frame&) const override { return Coverage::Background; }

 protected:
  BackgroundParams params(const FrameRun& run) const override;
};

}  // namespace quell

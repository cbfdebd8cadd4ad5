// Host side of the stage accumulate_noisy.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/accumulate_noisy_ports.h"

namespace quell {

QUELL_OPTIONS(AccumulateNoisyOptions, ACCUMULATE_NOISY, "accumulate_noisy")

/// See kernels/accumulate_noisy.cl for what it computes, from what and after which paper.
class AccumulateNoisy : public KernelStage<AccumulateNoisyOptions, AccumulateNoisyParams> {
 public:
  struct Setup {
    double leastWeight = 0.2;                        ///< least weight of the newest sample, (0, 1]
    double momentsLeastWeight = 0.0;                 ///< the same for the moments; 0: no moments
    bool filterGuides = false;                       ///< view depth and roughness for edge stops
    int mostFrames = QUELL_MAX_HISTORY_LENGTH;       ///< longest history, frames, 1 to 255
    int mostFramesStill = QUELL_MAX_HISTORY_LENGTH;  ///< the same of pixels that do not move on the screen
    bool skip = false;                               ///< finds the background; see kernels/common/surfaces.h
    bool antialiasBackground =
        false;                ///< whether background takes part in temporal_antialiasing even unjittered
    bool innovation = false;  ///< newest sample and its difference to the history
  };
  AccumulateNoisy(const Configuration& configuration, const Setup& setup);

 protected:
  AccumulateNoisyParams params(const FrameRun& run) const override;

 private:
  Setup m_setup;
};

}  // namespace quell

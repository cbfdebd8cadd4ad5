// Host side of the stage soft_history.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/fit_options.hpp"
#include "kernels/soft_history_ports.h"

namespace quell {

QUELL_OPTIONS(SoftHistoryOptions, SOFT_HISTORY, "soft_history")

/// See kernels/soft_history.cl for what it computes, from what and after which paper.
class SoftHistory : public KernelStage<SoftHistoryOptions, SoftHistoryParams> {
 public:
  struct Setup {
    int signal = 0;                 ///< 0 or 1
    bool virtualPositions = false;  ///< those of the stage virtual_motion instead of the surface's
    double hysteresis = 0.98;       ///< most weight of history, [0, 1)
    /// Distances in pixel footprints up to which history is trusted wholly, and from which on not at all; the same in scene
    /// units, added.
    double nearFootprints = 0.0, farFootprints = 0.0, nearDistance = 0.0, farDistance = 0.0;
    double clampSigma = 0.0;  ///< standard deviations; 0: history is not clamped
    bool meanFirst = false;   ///< history weighs at most as a mean over its frames does
    bool skip = false;        ///< leaves out background
  };
  SoftHistory(const Configuration& configuration, const Setup& setup);
  std::string label() const override { return name() + signalLabel(QUELL_SIGNAL); }

 protected:
  SoftHistoryParams params(const FrameRun& run) const override;

 private:
  Setup m_setup;
};

}  // namespace quell

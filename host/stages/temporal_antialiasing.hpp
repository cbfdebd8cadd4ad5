// Host side of the stage temporal_antialiasing.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/temporal_antialiasing_ports.h"

namespace quell {

QUELL_OPTIONS(TemporalAntialiasingOptions, TEMPORAL_ANTIALIASING, "temporal_antialiasing")

/// See kernels/temporal_antialiasing.cl for what it computes, from what and after which paper.
class TemporalAntialiasing : public KernelStage<TemporalAntialiasingOptions, TemporalAntialiasingParams> {
 public:
  struct Setup {
    double newestWeight = 0.2;         ///< of the newest frame, (0, 1]
    double silhouetteWeight = 0.2;     ///< the same where surfaces clearly apart meet
    bool antialiasLinear = false;      ///< writes the linear image as well
    bool antialiasBackground = false;  ///< background takes part whatever the camera's jitter
    bool skip = false;                 ///< leaves background that takes no part to the stage background
  };
  TemporalAntialiasing(const Configuration& configuration, const Setup& setup);
  Coverage coverage(const Frame& frame) const override;

 protected:
  TemporalAntialiasingParams params(const FrameRun& run) const override;

 private:
  double m_newestWeight, m_silhouetteWeight;
  bool m_antialiasBackground;
};

}  // namespace quell

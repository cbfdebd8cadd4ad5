// Host side of the stage variance.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/edge_stops.hpp"
#include "kernels/variance_ports.h"

namespace quell {

QUELL_OPTIONS(VarianceOptions, VARIANCE, "variance")

/// See kernels/variance.cl for what it computes, from what and after which paper.
class Variance : public KernelStage<VarianceOptions, VarianceParams> {
 public:
  struct Setup {
    EdgeStops stops;
    int temporalFrames = 4;      ///< history length from which on the variance over time is trusted, 1 to 255
    bool skip = false;           ///< leaves out background; see kernels/common/surfaces.h
    bool stopLuminance = false;  ///< also writes the luminance for the stops of atrous
    bool ofMean = false;         ///< variance of the mean over the history, else of its samples
    double fireflyRatio = 0.0;   ///< 1 or more: also writes weights for taps, less for fireflies; 0: does not
    double momentsLeastWeight = 1.0;  ///< least weight of the newest sample in the moments, (0, 1]
  };
  Variance(const Configuration& configuration, const Setup& setup);

 protected:
  VarianceParams params(const FrameRun& run) const override;

 private:
  Setup m_setup;
};

}  // namespace quell

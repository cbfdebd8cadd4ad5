// Host side of the stage atrous.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/edge_stops.hpp"
#include "kernels/atrous_ports.h"

namespace quell {

QUELL_OPTIONS(AtrousOptions, ATROUS, "atrous")

/// One iteration; see kernels/atrous.cl for what it computes, from what and after which paper.
class Atrous : public KernelStage<AtrousOptions, AtrousParams> {
 public:
  struct Setup {
    EdgeStops stops;
    double luminanceSigma = 4.0;  ///< in standard deviations; in units of luminance without variance
    int iteration = 1;            ///< from 1 on; taps are 2^(iteration - 1) pixels apart
    bool variance = false;        ///< stops on luminance in deviations of this variance
    bool stopLuminance =
        false;                ///< compares the luminance that the stage variance prefiltered; squared penalty
    bool tapWeights = false;  ///< weights of the stage variance, where fireflies have less
    bool filterVariance = false;  ///< filters it along; only with `variance`
    int radius = 2;               ///< 2: 5x5 taps, 1: 3x3
    bool corners = true;          ///< false: without the four corners of these
    /// Roughness below which the stop on luminance narrows, to half its width at 0; 0: nowhere.
    double sharpRoughness = 0.0;
    bool skip = false;  ///< leaves out background; see kernels/common/surfaces.h
  };
  Atrous(const Configuration& configuration, const Setup& setup);
  std::string label() const override { return name() + " (step " + std::to_string(step()) + ")"; }

 protected:
  AtrousParams params(const FrameRun& run) const override;

 private:
  int step() const { return 1 << (m_setup.iteration - 1); }  // pixels between taps

  Setup m_setup;
};

}  // namespace quell

// Host side of the stage separable_bilateral.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/edge_stops.hpp"
#include "kernels/separable_bilateral_ports.h"

namespace quell {

QUELL_OPTIONS(SeparableBilateralOptions, SEPARABLE_BILATERAL, "separable_bilateral")

/// See kernels/separable_bilateral.cl for what it computes, from what and after which paper.
class SeparableBilateral : public KernelStage<SeparableBilateralOptions, SeparableBilateralParams> {
 public:
  struct Setup {
    EdgeStops stops;
    int signal = 0;          ///< 0 or 1
    double sigma = 7.0;      ///< pixels, of a perfectly rough surface; > 0
    bool alongRows = false;  ///< taps of a row, else of a column
    bool skip = false;       ///< leaves out background
  };
  SeparableBilateral(const Configuration& configuration, const Setup& setup);
  std::string label() const override { return name() + (m_setup.alongRows ? " (rows)" : " (columns)"); }

 protected:
  SeparableBilateralParams params(const FrameRun& run) const override;

 private:
  Setup m_setup;
};

}  // namespace quell

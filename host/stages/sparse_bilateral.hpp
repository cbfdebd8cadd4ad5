// Host side of the stage sparse_bilateral.
#pragma once

#include "host/core/stage.hpp"
#include "host/stages/edge_stops.hpp"
#include "kernels/sparse_bilateral_ports.h"

namespace quell {

QUELL_OPTIONS(SparseBilateralOptions, SPARSE_BILATERAL, "sparse_bilateral")

/// See kernels/sparse_bilateral.cl for what it computes, from what and after which paper.
class SparseBilateral : public KernelStage<SparseBilateralOptions, SparseBilateralParams> {
 public:
  struct Setup {
    EdgeStops stops;
    double radiusShare = 0.0;  ///< of the image's width, > 0
    /// Follows the stage low_confidence: none where history is trusted, `lowFactor` times the radius where it is not.
    bool followsConfidence = false;
    double lowFactor = 1.0;
    bool skip = false;  ///< leaves out background
  };
  SparseBilateral(const Configuration& configuration, const Setup& setup);
  std::string label() const override {
    return name() + (m_setup.followsConfidence ? " (by confidence)" : " (history)");
  }

 protected:
  SparseBilateralParams params(const FrameRun& run) const override;

 private:
  Setup m_setup;
};

}  // namespace quell

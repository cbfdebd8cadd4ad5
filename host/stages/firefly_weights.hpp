// Host side of the stage firefly_weights.
#pragma once

#include "host/core/stage.hpp"
#include "kernels/firefly_weights_ports.h"

namespace quell {

QUELL_OPTIONS(FireflyWeightsOptions, FIREFLY_WEIGHTS, "firefly_weights")

/// See kernels/firefly_weights.cl for what it computes and from what.
class FireflyWeights : public KernelStage<FireflyWeightsOptions, FireflyWeightsParams> {
 public:
  /// `ratio`: of a pixel's luminance to that of the brightest around, > 0. `skip`: leaves out background; see
  /// kernels/common/surfaces.h.
  FireflyWeights(const Configuration& configuration, double ratio, bool skip);

 protected:
  FireflyWeightsParams params(const FrameRun& run) const override;

 private:
  double m_ratio;
};

}  // namespace quell

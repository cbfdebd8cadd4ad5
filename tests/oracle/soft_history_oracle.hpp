// Double-precision oracle of the stage soft_history (Mara et al. 2017, eq. 11), see kernels/soft_history.cl.
#pragma once

#include "kernels/common/reprojection_params.h"
#include "tests/support/planes.hpp"

namespace quell::tests {

/// Of one signal.
struct SoftHistoryInputs {
  Planes irradiance;     ///< 3 planes
  Planes weights;        ///< 1 plane
  Planes positions;      ///< 3 planes
  Planes positionsPrev;  ///< 3 planes
  Planes pixelPrev;      ///< 2 planes
  Planes tapMask;        ///< 1 plane
  Planes historyLength;  ///< 1 plane
  Planes historyPrev;    ///< 3 planes
  ReprojectionParams reprojection{};
  double hysteresis = 0.98;
  double nearFootprints = 4.0, farFootprints = 8.0;
  double clampSigma = 0.0;
  bool meanFirst = false;
  bool trustsMotion = false;
};

struct SoftHistoryExact {
  ExactPlanes blended;     ///< 3 planes
  ExactPlanes confidence;  ///< 1 plane
};

SoftHistoryExact softHistoryOracle(const SoftHistoryInputs& inputs);

}  // namespace quell::tests

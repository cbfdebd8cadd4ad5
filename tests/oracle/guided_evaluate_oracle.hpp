// Double-precision oracle of the stage guided_evaluate, see kernels/guided_evaluate.cl.
#pragma once

#include "kernels/guided_params.h"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct GuidedEvaluateInputs {
  Planes windowCoefficients;  ///< QUELL_GUIDED_COEFFICIENTS planes a signal, of cells
  Planes guides;              ///< of accumulate_noisy
  Planes viewDepth;           ///< 1 plane
  int subsampling = 1;

  int signals() const { return windowCoefficients.count / QUELL_GUIDED_COEFFICIENTS; }
};

struct GuidedEvaluateExact {
  ExactPlanes irradiance;  ///< 3 planes a signal
  ExactPlanes magnitudes;  ///< of the terms without their signs
};

GuidedEvaluateExact guidedEvaluateOracle(const GuidedEvaluateInputs& inputs);

}  // namespace quell::tests

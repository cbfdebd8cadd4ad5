// Double-precision oracle of the stage guided_solve: the regression of a guided filter, see kernels/guided_solve.cl.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernels/guided_params.h"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct GuidedSolveInputs {
  Planes windowMoments;  ///< QUELL_GUIDED_SUMS planes a signal, of cells
  double epsilon = 0.01;

  int signals() const { return windowMoments.count / QUELL_GUIDED_SUMS; }
};

using GuidedCoefficients = Eigen::Matrix<double, QUELL_GUIDED_FEATURES, QUELL_GUIDED_CHANNELS>;
using GuidedColumns = Eigen::Matrix<double, QUELL_GUIDED_FEATURES, 1>;

/// What solves a window.
struct GuidedFit {
  GuidedCoefficients coefficients = GuidedCoefficients::Zero();
  bool used = false;       ///< a pixel has a weight
  bool undecided = false;  ///< within rounding of having enough pixels for more than a mean
  GuidedColumns mean = GuidedColumns::Zero();       ///< of [1 | guides]
  GuidedColumns deviation = GuidedColumns::Zero();  ///< standard ones, of the guides
  double brightness = 0.0;                          ///< mean of the brightest channel
};

/// Signal by signal, row by row.
std::vector<GuidedFit> guidedSolveOracle(const GuidedSolveInputs& inputs);

}  // namespace quell::tests

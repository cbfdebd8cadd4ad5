// Host side of the stage guided_solve.
#pragma once

#include "host/stages/guided_grid.hpp"
#include "kernels/guided_solve_ports.h"

namespace quell {

QUELL_OPTIONS(GuidedSolveOptions, GUIDED_SOLVE, "guided_solve")

/// See kernels/guided_solve.cl for what it computes, from what and after which paper.
class GuidedSolve : public KernelStage<GuidedSolveOptions, GuidedParams> {
 public:
  /// `subsampling`: edge of a cell, pixels; `epsilon`: see kernels/guided_params.h, > 0.
  GuidedSolve(const Configuration& configuration, int subsampling, double epsilon);

 protected:
  GuidedParams params(const FrameRun& run) const override;
  std::array<std::size_t, 2> range(const FrameRun& run) const override;

 private:
  int m_subsampling;
  double m_epsilon;
};

}  // namespace quell

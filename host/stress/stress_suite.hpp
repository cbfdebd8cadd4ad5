// Families against bounds: the figures that `quell stress` prints and the tests assert.
#pragma once

#include <cstdint>

#include "host/stress/families.hpp"
#include "host/stress/oracle_fit.hpp"

namespace quell::stress {

/// Well-posed families: residual energy above the least there is, per energy of the signal about its mean.
constexpr double kMostExcessResidual = 0.01;
/// Ill-posed families: predictions stay inside the data's range widened by half its width at either end.
constexpr double kMostOutsideRange = 0.5;

/// The worst over all blocks of a family.
struct SolverFigures {
  FitErrors worst;  ///< of the blocks with finite results; `finite` is not used
  std::uint64_t blocks = 0;
  std::uint64_t nonFinite = 0;  ///< blocks with a result that is not finite

  double nonFiniteShare() const {
    return blocks > 0 ? static_cast<double>(nonFinite) / static_cast<double>(blocks) : 0.0;
  }
  void include(const FitErrors& errors);
};

struct FamilyFigures {
  SolverFigures householder, gram;

  SolverFigures& of(Solver solver) { return solver == Solver::Gram ? gram : householder; }
  const SolverFigures& of(Solver solver) const { return solver == Solver::Gram ? gram : householder; }
};

/// Blocks under one camera.
constexpr int kBatchBlocks = 32;

/// Fits at least `blocks` random blocks of a family, in whole batches. Throws quell::Error.
FamilyFigures runFamily(const Family& family, BlockFitter& fitter, std::uint64_t blocks, std::uint32_t seed);

bool withinBounds(const SolverFigures& figures, Posedness posedness);

}  // namespace quell::stress

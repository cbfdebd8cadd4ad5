#include "host/stress/stress_suite.hpp"

#include <algorithm>

namespace quell::stress {
namespace {

// What the bound of the class is about.
double judged(const FitErrors& errors, Posedness posedness) {
  return posedness == Posedness::Well ? errors.excessResidual : errors.outsideRange;
}

}  // namespace

void SolverFigures::include(const FitErrors& errors) {
  ++blocks;
  if (!errors.finite) {
    ++nonFinite;
    return;
  }
  worst.excessResidual = std::max(worst.excessResidual, errors.excessResidual);
  worst.prediction = std::max(worst.prediction, errors.prediction);
  worst.coefficient = std::max(worst.coefficient, errors.coefficient);
  worst.outsideRange = std::max(worst.outsideRange, errors.outsideRange);
}

FamilyFigures runFamily(const Family& family, BlockFitter& fitter, std::uint64_t blocks, std::uint32_t seed) {
  FamilyFigures figures;
  for (std::uint32_t index = 0; figures.gram.blocks < blocks; ++index) {
    const Batch batch = makeBatch(family, seed, index, kBatchBlocks);
    const BatchFit fits = fitter.fit(batch, seed + index * kBatchBlocks);
    for (const Solver solver : kSolvers)
      for (std::size_t block = 0; block < batch.blocks.size(); ++block)
        figures.of(solver).include(compareFit(fits.inputs[block], fits.of(solver)[block]));
  }
  return figures;
}

bool withinBounds(const SolverFigures& figures, Posedness posedness) {
  if (figures.nonFinite > 0) return false;
  return judged(figures.worst, posedness) <=
         (posedness == Posedness::Well ? kMostExcessResidual : kMostOutsideRange);
}

}  // namespace quell::stress

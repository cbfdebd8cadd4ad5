#include "host/stages/guided_solve.hpp"

#include "host/core/frame_images.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(GuidedSolveOptions, GUIDED_SOLVE)

GuidedSolve::GuidedSolve(const Configuration& configuration, int subsampling, double epsilon)
    : m_subsampling(subsampling), m_epsilon(epsilon) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  QUELL_FEATURES = QUELL_GUIDED_FEATURES;
  setCellSizes<GuidedSolveOptions>(*this, guidedCells(configuration.size(), subsampling));
}

GuidedParams GuidedSolve::params(const FrameRun& run) const {
  return makeGuidedParams(run.frame.size, m_subsampling, m_epsilon);
}

std::array<std::size_t, 2> GuidedSolve::range(const FrameRun& run) const {
  return cellItems(guidedCells(run.frame.size, m_subsampling), run.configuration.device.lanes);
}

}  // namespace quell

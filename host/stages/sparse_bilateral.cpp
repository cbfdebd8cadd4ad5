#include "host/stages/sparse_bilateral.hpp"

#include <cmath>

#include "host/stages/confidence_cells.hpp"
#include "host/stages/stage_options.hpp"
#include "kernels/common/sunflower.h"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {
namespace {

// From frame to frame the pattern turns by the share of a turn that never repeats: the golden ratio's.
constexpr double kTurnOfFrame = 0.61803398874989485;
constexpr double kFullTurn = 6.28318530717958648;  // radians

}  // namespace

QUELL_PORTS(SparseBilateralOptions, SPARSE_BILATERAL)

SparseBilateral::SparseBilateral(const Configuration& configuration, const Setup& setup) : m_setup(setup) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  ROUGHNESS_STOP = 0;
  CELL_RADIUS = setup.followsConfidence ? 1 : 0;
  setCellSizes<SparseBilateralOptions>(*this, confidenceCells(configuration.size()));
  setSkipOptions<SparseBilateralOptions>(*this, configuration, setup.skip);
}

SparseBilateralParams SparseBilateral::params(const FrameRun& run) const {
  SparseBilateralParams params{};
  params.planes = makePlanes(run.frame.size);
  params.cells = makePlanes(confidenceCells(run.frame.size));
  params.stops = makeEdgeStopParams(m_setup.stops);
  params.radius = static_cast<float>(m_setup.radiusShare * run.frame.size.width);
  params.lowFactor = static_cast<float>(m_setup.lowFactor);
  const double angle = kFullTurn * std::fmod(run.frameIndex * kTurnOfFrame, 1.0);
  params.cosine = static_cast<int>(std::lround(QUELL_SUNFLOWER_UNIT * std::cos(angle)));
  params.sine = static_cast<int>(std::lround(QUELL_SUNFLOWER_UNIT * std::sin(angle)));
  return params;
}

}  // namespace quell

#include "host/stages/low_confidence.hpp"

#include "host/core/frame_images.hpp"
#include "host/stages/confidence_cells.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(LowConfidenceOptions, LOW_CONFIDENCE)

LowConfidence::LowConfidence(const Configuration& configuration) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  setCellSizes<LowConfidenceOptions>(*this, confidenceCells(configuration.size()));
}

LowConfidenceParams LowConfidence::params(const FrameRun& run) const {
  return {makePlanes(run.frame.size), makePlanes(confidenceCells(run.frame.size))};
}

std::array<std::size_t, 2> LowConfidence::range(const FrameRun& run) const {
  return cellItems(confidenceCells(run.frame.size), 1);
}

}  // namespace quell

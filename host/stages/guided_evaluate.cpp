#include "host/stages/guided_evaluate.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(GuidedEvaluateOptions, GUIDED_EVALUATE)

GuidedEvaluate::GuidedEvaluate(const Configuration& configuration, int subsampling, bool skip) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  SUBSAMPLING = subsampling;
  setCellSizes<GuidedEvaluateOptions>(*this, guidedCells(configuration.size(), subsampling));
  setSkipOptions<GuidedEvaluateOptions>(*this, configuration, skip);
}

GuidedParams GuidedEvaluate::params(const FrameRun& run) const {
  return makeGuidedParams(run.frame.size, SUBSAMPLING, 0.0);
}

}  // namespace quell

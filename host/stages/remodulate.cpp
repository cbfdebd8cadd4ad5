#include "host/stages/remodulate.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(RemodulateOptions, REMODULATE)

Remodulate::Remodulate(const Configuration& configuration, bool writePlanes, bool skip) {
  setLightOptions<RemodulateOptions>(*this, configuration);
  setSkipOptions<RemodulateOptions>(*this, configuration, skip);
  WRITE_PLANES = writePlanes ? 1 : 0;
}

RemodulateParams Remodulate::params(const FrameRun& run) const {
  RemodulateParams params{};
  params.planes = makePlanes(run.frame.size);
  params.images = makeImageParams(run.frame);
  params.outputs = makeImageParams(run.output, run.frame.size);
  return params;
}

}  // namespace quell

#include "host/stages/demodulate.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(DemodulateOptions, DEMODULATE)

Demodulate::Demodulate(const Configuration& configuration, bool skip) {
  setLightOptions<DemodulateOptions>(*this, configuration);
  setSkipOptions<DemodulateOptions>(*this, configuration, skip);
}

DemodulateParams Demodulate::params(const FrameRun& run) const {
  DemodulateParams params{};
  params.reprojection = run.reprojection;
  params.planes = makePlanes(run.frame.size);
  params.images = makeImageParams(run.frame);
  return params;
}

}  // namespace quell

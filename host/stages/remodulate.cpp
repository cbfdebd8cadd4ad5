#include "host/stages/remodulate.hpp"

#include "host/stages/stage_options.hpp"
#include "host/stages/tiles.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(RemodulateOptions, REMODULATE)

Remodulate::Remodulate(const Configuration& configuration, const Setup& setup) {
  setLightOptions<RemodulateOptions>(*this, configuration);
  setSkipOptions<RemodulateOptions>(*this, configuration, setup.skip);
  setDisplayOptions<RemodulateOptions>(*this, configuration);
  WRITE_PLANES = setup.antialias ? 1 : 0;
  KEEP_LIGHT = setup.keepLight ? 1 : 0;
  lightTiles = tileCount(configuration.size(), QUELL_SIGNALS);
  ANTIALIAS_LINEAR = setup.antialiasLinear ? 1 : 0;
}

RemodulateParams Remodulate::params(const FrameRun& run) const {
  RemodulateParams params{};
  params.planes = makePlanes(run.frame.size);
  params.images = makeImageParams(run.frame);
  params.outputs = makeImageParams(run.output, run.frame.size);
  params.exposure = exposureFactor(run.configuration);
  params.tilesX = tilesAlong(run.frame.size.width);
  params.tilesY = tilesAlong(run.frame.size.height);
  return params;
}

}  // namespace quell

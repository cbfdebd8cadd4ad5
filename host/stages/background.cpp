#include "host/stages/background.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(BackgroundOptions, BACKGROUND)

Background::Background(const Configuration& configuration, const Setup& setup) {
  setLightOptions<BackgroundOptions>(*this, configuration);
  setSkipOptions<BackgroundOptions>(*this, configuration, true);
  setDisplayOptions<BackgroundOptions>(*this, configuration);
  ANTIALIAS = setup.antialias ? 1 : 0;
  ANTIALIAS_LINEAR = setup.antialiasLinear ? 1 : 0;
  antialiasBackground = setup.antialias && setup.antialiasBackground ? 1 : 0;
}

BackgroundParams Background::params(const FrameRun& run) const {
  BackgroundParams params{};
  params.planes = makePlanes(run.frame.size);
  params.images = makeImageParams(run.frame);
  params.outputs = makeImageParams(run.output, run.frame.size);
  params.exposure = exposureFactor(run.configuration);
  const bool isAntialiased = ANTIALIAS != 0 && (antialiasBackground != 0 || isJittered(run.frame.camera));
  params.finish = isAntialiased ? 0 : 1;
  return params;
}

}  // namespace quell

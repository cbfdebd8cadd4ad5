#include "host/stages/temporal_antialiasing.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(TemporalAntialiasingOptions, TEMPORAL_ANTIALIASING)

TemporalAntialiasing::TemporalAntialiasing(const Configuration& configuration, const Setup& setup)
    : m_newestWeight(setup.newestWeight),
      m_silhouetteWeight(setup.silhouetteWeight),
      m_antialiasBackground(setup.antialiasBackground) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  setSkipOptions<TemporalAntialiasingOptions>(*this, configuration, setup.skip);
  setDisplayOptions<TemporalAntialiasingOptions>(*this, configuration);
  ANTIALIAS_LINEAR = setup.antialiasLinear ? 1 : 0;
}

Coverage TemporalAntialiasing::coverage(const Frame& frame) const {
  return isJittered(frame.camera) ? Coverage::Everything : Coverage::AroundSurfaces;
}

TemporalAntialiasingParams TemporalAntialiasing::params(const FrameRun& run) const {
  TemporalAntialiasingParams params{};
  params.planes = makePlanes(run.frame.size);
  params.outputs = makeImageParams(run.output, run.frame.size);
  params.exposure = exposureFactor(run.configuration);
  params.newestWeight = static_cast<float>(m_newestWeight);
  params.silhouetteWeight = static_cast<float>(m_silhouetteWeight);
  params.backgroundDepth = run.reprojection.viewDepth.w;
  params.antialiasBackground = m_antialiasBackground || isJittered(run.frame.camera) ? 1 : 0;
  return params;
}

}  // namespace quell

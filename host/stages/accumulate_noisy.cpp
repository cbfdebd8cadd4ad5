#include "host/stages/accumulate_noisy.hpp"

#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(AccumulateNoisyOptions, ACCUMULATE_NOISY)

AccumulateNoisy::AccumulateNoisy(const Configuration& configuration, const Setup& setup) : m_setup(setup) {
  setLightOptions<AccumulateNoisyOptions>(*this, configuration);
  setSkipOptions<AccumulateNoisyOptions>(*this, configuration, setup.skip);
  MOMENTS = setup.momentsLeastWeight > 0.0 ? 1 : 0;
  FILTER_GUIDES = setup.filterGuides ? 1 : 0;
  INNOVATION = setup.innovation ? 1 : 0;
  antialiasBackground = setup.antialiasBackground ? 1 : 0;
}

AccumulateNoisyParams AccumulateNoisy::params(const FrameRun& run) const {
  AccumulateNoisyParams params{};
  params.reprojection = run.reprojection;
  params.planes = makePlanes(run.frame.size);
  params.images = makeImageParams(run.frame);
  params.leastWeight = static_cast<float>(m_setup.leastWeight);
  params.momentsLeastWeight = static_cast<float>(m_setup.momentsLeastWeight);
  params.mostFrames = m_setup.mostFrames;
  params.mostFramesStill = m_setup.mostFramesStill;
  params.antialiasBackground = m_setup.antialiasBackground || isJittered(run.frame.camera) ? 1 : 0;
  return params;
}

}  // namespace quell

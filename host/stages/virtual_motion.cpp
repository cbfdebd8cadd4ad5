#include "host/stages/virtual_motion.hpp"

#include "host/core/reprojection.hpp"
#include "host/stages/stage_options.hpp"
// After all others: short names.
#include "host/core/port_columns.hpp"

namespace quell {

QUELL_PORTS(VirtualMotionOptions, VIRTUAL_MOTION)

VirtualMotion::VirtualMotion(const Configuration& configuration, bool skip) {
  QUELL_SIGNALS = signalCount(configuration.frame);
  setSkipOptions<VirtualMotionOptions>(*this, configuration, skip);
}

VirtualMotionParams VirtualMotion::params(const FrameRun& run) const {
  VirtualMotionParams params{};
  params.reprojection = run.reprojection;
  params.planes = makePlanes(run.frame.size);
  params.images = makeImageParams(run.frame);
  params.parallel = isOrthographic(run.frame.camera.worldToClip) ? 1 : 0;
  return params;
}

}  // namespace quell

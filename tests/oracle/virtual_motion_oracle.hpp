// Double-precision oracle of the stage virtual_motion (Mara et al. 2017, stage 8), see kernels/virtual_motion.cl.
#pragma once

#include "host/io/image.hpp"
#include "kernels/common/reprojection_params.h"
#include "tests/support/planes.hpp"

namespace quell::tests {

struct VirtualMotionInputs {
  io::Image hitDistance;  ///< 1 channel
  Planes guides;          ///< of accumulate_noisy, two signals
  Planes guidesPrev;
  Planes pixelPrev;         ///< of the surface, 2 planes
  Planes reprojectionMask;  ///< of the surface, a plane a signal
  ReprojectionParams reprojection{};
  bool parallel = false;
};

struct VirtualMotionExact {
  ExactPlanes positions;        ///< 3 planes
  ExactPlanes pixelPrev;        ///< 2 planes, not rounded
  ExactPlanes mask;             ///< 1 plane
  BasicPlanes<char> undecided;  ///< within rounding of the border, or of the limit of normals
};

/// `pixelPrev`: as the device rounded it.
VirtualMotionExact virtualMotionOracle(const VirtualMotionInputs& inputs, const Planes& pixelPrev);

}  // namespace quell::tests

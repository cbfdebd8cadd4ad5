// From the caller's camera to what kernels need, in double precision.
#pragma once

#include <array>
#include <quell/camera.hpp>
#include <quell/image_view.hpp>

#include "host/core/view_rays.hpp"
#include "kernels/common/reprojection_params.h"

namespace quell {

/// When a history sample shows the same surface (Koskela et al. 2019, phase I).
struct DiscardLimits {
  double position = 0.0;            ///< scene units; added to the next
  double positionFootprints = 0.0;  ///< in footprints of a pixel at the surface's distance
  double normalSquared = 0.0;       ///< squared difference of unit normals
};

/// Throws Error(InvalidArgument) naming the matrix if one is not finite or cannot be a camera.
/// `historyValid` is false on the first frame; worldToClipPrev is then ignored. `motionScale` as Frame has it.
ReprojectionParams makeReprojectionParams(const Camera& camera, Size size, const DiscardLimits& limits,
                                          bool historyValid,
                                          const std::array<double, 2>& motionScale = {1.0, 1.0});

/// World position of the camera: where clip x, y and w vanish; for orthographic cameras the point of the
/// view axis that is nearest the world origin. Throws as above.
std::array<double, 3> cameraPositionWorld(const Matrix4& worldToClip, const char* name);

}  // namespace quell

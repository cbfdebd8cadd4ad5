// A camera without lens: where it stands, where it looks, and the matrices that follow.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <quell/camera.hpp>

#include "kernels/render/scene_params.h"

namespace quell::render {

/// World space is right-handed, z up, metres.
struct PinholeCamera {
  glm::dvec3 eye{0.0, -5.0, 1.5};
  glm::dvec3 target{0.0, 0.0, 1.0};  ///< not straight above or below the eye
  double fieldOfViewDeg = 45.0;      ///< vertical, in (0, 180)
  /// Where rays pass through their pixel, as quell::Camera has it; matrices and motion are without it.
  std::array<double, 2> jitterPx{0.0, 0.0};
};

/// World to clip as quell::Camera wants it; width and height in pixels, >= 1.
Matrix4 worldToClip(const PinholeCamera& camera, int width, int height);

/// Rays and projection for the kernels.
RenderCamera makeRenderCamera(const PinholeCamera& camera, int width, int height);

/// Width of a pixel at distance 1 from the eye, at the centre of the image.
double pixelAngle(const PinholeCamera& camera, int height);

}  // namespace quell::render

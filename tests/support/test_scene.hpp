// A scene for reprojection: a fence of tilted slats before a wall, open sky above, seen by a moving camera.
// What a pixel shows depends on the world position alone, so two cameras agree on it wherever both see it.
#pragma once

#include <quell/camera.hpp>

#include "host/io/image.hpp"
#include "kernels/common/reprojection_params.h"
#include "tests/support/planes.hpp"

namespace quell::tests {

/// A pinhole camera that looks along -z, turned about the vertical axis.
struct TestCamera {
  double x = 10.3, y = -20.7, z = 30.1;  ///< world position, scene units
  double yaw = 0.0;                      ///< radians, to the left
  std::array<double, 2> jitterPx{0, 0};  ///< as quell::Camera has it
};

/// How far the camera of the frame before stood from the one of this frame in the usual test: about two
/// pixels of motion at 480 pixels of width, more on the fence than on the wall.
TestCamera movedCamera();

Matrix4 worldToClip(const TestCamera& camera, Size size);

/// Both cameras of a frame.
Camera makeCamera(const TestCamera& now, const TestCamera& before, Size size);

/// With the limits of the method's defaults.
ReprojectionParams makeReprojection(const TestCamera& now, const TestCamera& before, Size size,
                                    bool historyValid = true);

/// Buffers of one view. The sky has a zero normal and position 0.
struct SceneView {
  io::Image positionWorld;  ///< 3 channels
  io::Image viewDepth;      ///< 1 channel
  io::Image normalWorld;    ///< 3 channels
  Planes guides;            ///< as accumulate_noisy keeps them; weights 1, 0 on the sky
};
/// With `holes`, background also where isHole() says.
SceneView renderScene(const TestCamera& camera, Size size, int signals = 1, bool holes = false);

/// Holes of background: a quarter of the image, in the rest runs of 16 pixels of a row and single pixels.
bool isHole(Size size, int x, int y);

}  // namespace quell::tests

#include "tests/support/test_scene.hpp"

#include <Eigen/Core>
#include <cmath>

#include "host/core/reprojection.hpp"
#include "host/methods/method.hpp"
#include "kernels/accumulate_noisy_params.h"
#include "tests/support/random_images.hpp"

namespace quell::tests {
namespace {

using Eigen::Vector3d;

constexpr double kFocalLength = 1.5;       // of a picture that is 2 high
const Vector3d kSceneOrigin(10, -21, 30);  // the scene lies around it, scene units
constexpr double kFenceZ = -4.0;           // distances from the origin along z, scene units
constexpr double kWallZ = -6.0;
constexpr double kSkyY = 1.9;          // height above which there is nothing
constexpr double kSlatsPerUnit = 4.0;  // radians per scene unit
constexpr int kHoleRun = 16;           // pixels: the most lanes
constexpr double kHoleShare = 0.35;    // of the runs
constexpr double kSinglePixelShare = 0.1;

struct Axes {
  Vector3d position, right, up, forward;
};

Axes axesOf(const TestCamera& camera) {
  const double c = std::cos(camera.yaw), s = std::sin(camera.yaw);
  return {{camera.x, camera.y, camera.z}, {c, 0, -s}, {0, 1, 0}, {-s, 0, -c}};
}

struct Hit {
  double depth = 0.0;  // 0: sky
  Vector3d relative = Vector3d::Zero();
  Vector3d normal = Vector3d::Zero();
};

Hit intersect(const Axes& axes, const Vector3d& ray) {
  const auto depthAt = [&](double z) { return (kSceneOrigin.z() + z - axes.position.z()) / ray.z(); };
  const double fence = depthAt(kFenceZ);
  const Vector3d onFence = axes.position + fence * ray - kSceneOrigin;
  if (std::sin(kSlatsPerUnit * onFence.x()) > 0.4 && onFence.y() < kSkyY)
    return {fence, fence * ray, Vector3d(0.3, 0.2 * std::sin(2.0 * onFence.y()), 1.0).normalized()};
  const double wall = depthAt(kWallZ);
  const Vector3d onWall = axes.position + wall * ray - kSceneOrigin;
  if (onWall.y() >= kSkyY) return {};
  return {wall, wall * ray,
          Vector3d(-0.3 * std::sin(onWall.x()), 0.2 * std::cos(onWall.y()), 1.0).normalized()};
}

void storeHit(SceneView& view, const Axes& axes, int x, int y, const Hit& hit) {
  view.viewDepth.at(x, y, 0) = float(hit.depth);
  if (hit.depth == 0.0) return;
  for (int axis = 0; axis < 3; ++axis) {
    view.positionWorld.at(x, y, axis) = float(axes.position[axis] + hit.relative[axis]);
    view.normalWorld.at(x, y, axis) = float(hit.normal[axis]);
    view.guides.at(QUELL_GUIDE_POSITION + axis, x, y) = float(hit.relative[axis]);
    view.guides.at(QUELL_GUIDE_NORMAL + axis, x, y) = float(hit.normal[axis]);
  }
  for (int plane = QUELL_GUIDE_WEIGHT; plane < view.guides.count; ++plane) view.guides.at(plane, x, y) = 1.0f;
}

}  // namespace

TestCamera movedCamera() {
  TestCamera camera;
  camera.x += 0.03;
  camera.y -= 0.01;
  camera.z += 0.05;
  camera.yaw = 0.004;
  return camera;
}

Matrix4 worldToClip(const TestCamera& camera, Size size) {
  const Axes axes = axesOf(camera);
  const Vector3d rows[4] = {axes.right * (kFocalLength * size.height / size.width), axes.up * kFocalLength,
                            Vector3d::Zero(), axes.forward};
  Matrix4 matrix{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) matrix[4 * row + std::size_t(column)] = rows[row][column];
    matrix[4 * row + 3] = -rows[row].dot(axes.position);
  }
  return matrix;
}

Camera makeCamera(const TestCamera& now, const TestCamera& before, Size size) {
  Camera camera;
  camera.worldToClip = worldToClip(now, size);
  camera.worldToClipPrev = worldToClip(before, size);
  camera.jitterPx = now.jitterPx;
  return camera;
}

ReprojectionParams makeReprojection(const TestCamera& now, const TestCamera& before, Size size,
                                    bool historyValid) {
  const DiscardLimits limits = findMethod("bmfr").runtimeSettings(Settings("bmfr")).discard;
  return makeReprojectionParams(makeCamera(now, before, size), size, limits, historyValid);
}

bool isHole(Size size, int x, int y) {
  if (x >= size.width / 2 && y >= size.height / 2) return true;
  return Random(unsigned(1000 * y + x / kHoleRun)).uniform() < kHoleShare ||
         Random(unsigned(1000 * (y + size.height) + x)).uniform() < kSinglePixelShare;
}

SceneView renderScene(const TestCamera& camera, Size size, int signals, bool holes) {
  const Axes axes = axesOf(camera);
  SceneView view{io::Image(size.width, size.height, 3), io::Image(size.width, size.height, 1),
                 io::Image(size.width, size.height, 3), Planes(size, QUELL_GUIDE_WEIGHT + signals)};
  forEachPixel(size, [&](int x, int y) {
    if (holes && isHole(size, x, y)) return;
    const double column = x + 0.5 + camera.jitterPx[0], row = y + 0.5 + camera.jitterPx[1];
    const double right = (2.0 * column - size.width) / size.height / kFocalLength;
    const double up = (size.height - 2.0 * row) / size.height / kFocalLength;
    storeHit(view, axes, x, y, intersect(axes, axes.forward + right * axes.right + up * axes.up));
  });
  return view;
}

}  // namespace quell::tests

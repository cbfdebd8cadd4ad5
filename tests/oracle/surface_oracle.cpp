#include "tests/oracle/surface_oracle.hpp"

#include <algorithm>
#include <cmath>

namespace quell::tests {

Vector3d linearPart(const QuellFloat4& row) { return {row.x, row.y, row.z}; }

Vector3d viewRay(const ReprojectionParams& params, int x, int y) {
  return linearPart(params.rayOrigin) + x * linearPart(params.rayX) + y * linearPart(params.rayY);
}

Surface surfaceAt(const FrameImages& frame, int x, int y, bool& undecided) {
  const ReprojectionParams& params = frame.reprojection;
  const Vector3d position = rgbAt(frame.position, x, y);
  Surface surface;
  surface.normal = rgbAt(frame.normal, x, y);
  surface.position = frame.positionIsDepth
                         ? Vector3d(position.x() * viewRay(params, x, y))
                         : Vector3d(position - linearPart(params.cameraHigh) - linearPart(params.cameraLow));
  const double length = surface.normal.squaredNorm();
  for (const double limit : {QUELL_MIN_NORMAL_SQUARED, QUELL_MAX_NORMAL_SQUARED})
    undecided = undecided || std::abs(length - limit) <= kSurfaceRounding * limit;
  surface.valid = surface.position.allFinite() &&
                  surface.position.cwiseAbs().maxCoeff() < QUELL_MAX_POSITION &&
                  length >= QUELL_MIN_NORMAL_SQUARED && length <= QUELL_MAX_NORMAL_SQUARED;
  if (!surface.valid) return Surface();
  surface.normal.normalize();
  return surface;
}

Vector3d turnedNormal(const Vector3d& n, const std::array<bool, 3>& weak) {
  const Vector3d onlyRed(n[1], -n[2], n[0]), onlyGreen(n[2], n[0], -n[1]);
  const int count = weak[0] + weak[1] + weak[2];
  if (count == 0) return n;
  if (count == 3) return -n;
  if (count == 1) return -onlyGreen;
  return !weak[0] ? onlyRed : !weak[1] ? onlyGreen : Vector3d(-onlyRed);
}

Surface filteredSurfaceAt(const FrameImages& frame, int x, int y, bool& undecided) {
  Surface surface = surfaceAt(frame, x, y, undecided);
  if (frame.material.signals() == 2) return surface;
  const Material only = materialAt(frame.material, x, y);
  undecided = undecided || only.undecided;
  const bool emits = only.vanishes() && only.emission.maxCoeff() > 0.0;
  if (!emits) surface.normal = turnedNormal(surface.normal, only.weak);
  return surface;
}

double viewDepthOf(const FrameImages& frame, const Surface& surface) {
  const QuellFloat4& axis = frame.reprojection.viewDepth;
  return linearPart(axis).dot(surface.position) + axis.w;
}

double roughnessAt(const FrameImages& frame, int x, int y) {
  const double roughness = frame.roughness.at(x, y, 0);
  return std::isfinite(roughness) ? std::clamp(roughness, 0.0, 1.0) : 1.0;
}

double cosineOf(const Surface& surface) {
  return std::abs(surface.position.normalized().dot(surface.normal.normalized()));
}

Vector3d f0At(const FrameImages& frame, int x, int y) {
  return rgbAt(frame.material.f0, x, y).unaryExpr([](double f) {
    return std::isfinite(f) ? std::clamp(f, 0.0, 1.0) : 0.0;
  });
}

}  // namespace quell::tests

#include "tests/oracle/virtual_motion_oracle.hpp"

#include <cmath>

#include "kernels/common/guides.h"
#include "tests/oracle/bilinear_oracle.hpp"
#include "tests/oracle/surface_oracle.hpp"

namespace quell::tests {
namespace {

// Of a pixel index in float, and its rounding to a step.
constexpr double kPixelRounding = 1e-3 + 0.5 / QUELL_SUBPIXEL_STEPS;
constexpr double kNormalRounding = 1e-6;
constexpr int kLastSignal = 1;

Vector3d vectorAt(const Planes& planes, int first, int x, int y) {
  return {planes.at(first, x, y), planes.at(first + 1, x, y), planes.at(first + 2, x, y)};
}

// How far behind the surface the virtual point lies; 0: not known.
double hitAt(const VirtualMotionInputs& inputs, int x, int y) {
  const double hit = inputs.hitDistance.at(x, y, 0);
  return std::isfinite(hit) && hit > 0.0 && hit < QUELL_MAX_POSITION ? hit : 0.0;
}

struct Place {
  double x = 0.0, y = 0.0;
  bool inside = false, undecided = false;
};

Place placeOf(const VirtualMotionInputs& inputs, const Vector3d& point, int x, int y) {
  const ReprojectionParams& params = inputs.reprojection;
  const auto apply = [&](const QuellFloat4& row) { return linearPart(row).dot(point) + row.w; };
  const double w = apply(params.clipW), wPrev = apply(params.clipWPrev);
  if (!(w > 0.0 && wPrev > 0.0)) return {};
  const double xPrev = x + apply(params.pixelXPrev) / wPrev - apply(params.pixelX) / w;
  const double yPrev = y + apply(params.pixelYPrev) / wPrev - apply(params.pixelY) / w;
  const Size size = inputs.guides.size();
  const auto near = [](double value, double border) { return std::abs(value - border) < kPixelRounding; };
  const bool undecided =
      near(xPrev, -1.0) || near(yPrev, -1.0) || near(xPrev, size.width) || near(yPrev, size.height);
  const bool inside = xPrev > -1.0 && yPrev > -1.0 && xPrev < size.width && yPrev < size.height;
  return inside ? Place{xPrev, yPrev, true, undecided} : Place{0.0, 0.0, false, undecided};
}

int acceptedTaps(const VirtualMotionInputs& inputs, const Vector3d& normal, double xPrev, double yPrev,
                 char& undecided) {
  int mask = 0;
  for (const Tap& tap : bilinearTaps(inputs.guides.size(), xPrev, yPrev)) {
    if (!tap.inFrame || tap.weight <= 0.0) continue;
    if (inputs.guidesPrev.at(QUELL_GUIDE_WEIGHT + kLastSignal, tap.x, tap.y) <= 0.0f) continue;
    const double step =
        (vectorAt(inputs.guidesPrev, QUELL_GUIDE_NORMAL, tap.x, tap.y) - normal).squaredNorm();
    const double limit = inputs.reprojection.normalLimitSquared;
    undecided |= char(std::abs(step - limit) < kNormalRounding);
    if (step <= limit) mask |= QUELL_TAP_ACCEPTED(tap.index);
  }
  return mask;
}

}  // namespace

VirtualMotionExact virtualMotionOracle(const VirtualMotionInputs& inputs, const Planes& pixelPrev) {
  const Size size = inputs.guides.size();
  VirtualMotionExact exact{ExactPlanes(size, 3), ExactPlanes(size, 2), ExactPlanes(size, 1),
                           BasicPlanes<char>(size, 1)};
  forEachPixel(size, [&](int x, int y) {
    const Vector3d surface = vectorAt(inputs.guides, QUELL_GUIDE_POSITION, x, y);
    const Vector3d normal = vectorAt(inputs.guides, QUELL_GUIDE_NORMAL, x, y);
    const double hit = normal.isZero() ? 0.0 : hitAt(inputs, x, y);
    const Vector3d along =
        inputs.parallel ? linearPart(inputs.reprojection.viewDepth) : Vector3d(surface.normalized());
    const Vector3d point = hit > 0.0 ? Vector3d(surface + hit * along) : surface;
    for (int axis = 0; axis < 3; ++axis) exact.positions.at(axis, x, y) = point[axis];
    if (hit == 0.0) {
      for (int axis = 0; axis < 2; ++axis) exact.pixelPrev.at(axis, x, y) = inputs.pixelPrev.at(axis, x, y);
      exact.mask.at(0, x, y) = inputs.reprojectionMask.at(kLastSignal, x, y);
      return;
    }
    const Place place = placeOf(inputs, point, x, y);
    exact.pixelPrev.at(0, x, y) = place.x;
    exact.pixelPrev.at(1, x, y) = place.y;
    char& undecided = exact.undecided.at(0, x, y);
    undecided = char(place.undecided);
    if (place.inside)
      exact.mask.at(0, x, y) =
          acceptedTaps(inputs, normal, pixelPrev.at(0, x, y), pixelPrev.at(1, x, y), undecided);
  });
  return exact;
}

}  // namespace quell::tests

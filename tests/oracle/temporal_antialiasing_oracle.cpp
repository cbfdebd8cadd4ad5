#include "tests/oracle/temporal_antialiasing_oracle.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/accumulate_noisy_params.h"
#include "tests/oracle/bicubic_oracle.hpp"

namespace quell::tests {
namespace {

using Eigen::Vector3d;

Vector3d colorAt(const Planes& planes, int x, int y) {
  return {planes.at(0, x, y), planes.at(1, x, y), planes.at(2, x, y)};
}

Vector3d toYCoCg(const Vector3d& rgb) {
  return {0.25 * rgb.x() + 0.5 * rgb.y() + 0.25 * rgb.z(), 0.5 * (rgb.x() - rgb.z()),
          -0.25 * rgb.x() + 0.5 * rgb.y() - 0.25 * rgb.z()};
}

Vector3d toRgb(const Vector3d& v) { return {v.x() + v.y() - v.z(), v.x() + v.z(), v.x() - v.y() - v.z()}; }

struct Bounds {
  Vector3d low, high;
  void include(const Vector3d& v) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
};

// Mean of the bounds of the 3x3 box and of its cross, in YCoCg.
Bounds neighbourhood(const Planes& denoised, int x, int y) {
  const Vector3d centre = toYCoCg(colorAt(denoised, x, y));
  Bounds box{centre, centre}, cross{centre, centre};
  for (int row = y - 1; row <= y + 1; ++row) {
    for (int column = x - 1; column <= x + 1; ++column) {
      if (row < 0 || row >= denoised.height || column < 0 || column >= denoised.width) continue;
      const Vector3d neighbour = toYCoCg(colorAt(denoised, column, row));
      box.include(neighbour);
      if (row == y || column == x) cross.include(neighbour);
    }
  }
  return {0.5 * (box.low + cross.low), 0.5 * (box.high + cross.high)};
}

bool isRejected(const Planes& mask, int x, int y) {
  return (int(mask.at(0, x, y)) & QUELL_HISTORY_REJECTED) != 0;
}

// How many of the 3x3 pixels around met their own history, or were not asked.
int acceptedAround(const Planes& mask, int x, int y) {
  int accepted = 0;
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, mask.height - 1); ++row)
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, mask.width - 1); ++column)
      accepted += !isRejected(mask, column, row);
  return accepted;
}

struct Place {
  double x, y;
  bool inFrame = false;
  bool silhouette = false;
};

bool isPrevInFrame(const Planes& mask, int x, int y) {
  return (int(mask.at(0, x, y)) & QUELL_PREV_IN_FRAME) != 0;
}

// View depth, endless where there is no surface.
double depthAt(const TemporalAntialiasingInputs& inputs, int x, int y) {
  const double depth = inputs.viewDepth.at(0, x, y);
  return depth != 0.0 ? depth : std::numeric_limits<double>::infinity();
}

bool clearlyNearer(double depth, double than) { return depth < 0.97 * than; }

// Where the pixel was, if it moved as the nearest surface around; what is nearer by less than 3 % is the same one.
// Background that takes no part was nowhere, but next to a surface.
Place nearestPrev(const TemporalAntialiasingInputs& inputs, int x, int y) {
  const double own = depthAt(inputs, x, y);
  Place prev{double(x), double(y)};
  if (inputs.antialiasBackground || std::isfinite(own)) {
    prev.x = inputs.pixelPrev.at(0, x, y);
    prev.y = inputs.pixelPrev.at(1, x, y);
    prev.inFrame = isPrevInFrame(inputs.reprojectionMask, x, y);
  }
  double nearest = own;
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, inputs.denoised.height - 1); ++row) {
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, inputs.denoised.width - 1); ++column) {
      const double depth = depthAt(inputs, column, row);
      prev.silhouette = prev.silhouette || clearlyNearer(depth, own) || clearlyNearer(own, depth);
      if (!clearlyNearer(depth, nearest)) continue;
      nearest = depth;
      prev.x = double(inputs.pixelPrev.at(0, column, row)) - (column - x);
      prev.y = double(inputs.pixelPrev.at(1, column, row)) - (row - y);
      prev.inFrame = isPrevInFrame(inputs.reprojectionMask, column, row);
    }
  }
  return prev;
}

bool touchesFrame(Size size, const Place& place) {
  return place.x > -1.0 && place.x < size.width && place.y > -1.0 && place.y < size.height;
}

// Catmull-Rom, outside the frame the pixel at its border.
Vector3d sample(const Planes& planes, const Place& place) {
  Vector3d color = Vector3d::Zero();
  double weightSum = 0.0;
  for (const CubicTap& tap : bicubicTaps(planes.size(), place.x, place.y)) {
    color += tap.weight * colorAt(planes, tap.x, tap.y);
    weightSum += tap.weight;
  }
  return color / weightSum;
}

}  // namespace

ExactPlanes temporalAntialiasingOracle(const TemporalAntialiasingInputs& inputs) {
  ExactPlanes antialiased(inputs.denoised.size(), 3);
  forEachPixel(inputs.denoised.size(), [&](int x, int y) {
    Vector3d color = colorAt(inputs.denoised, x, y);
    const Place prev = nearestPrev(inputs, x, y);
    const int accepted = acceptedAround(inputs.reprojectionMask, x, y);
    const bool met = accepted > 0 || !isRejected(inputs.reprojectionMask, x, y);
    if (prev.inFrame && met && touchesFrame(inputs.denoised.size(), prev)) {
      const Vector3d history = sample(inputs.antialiasedPrev, prev);
      const Bounds bounds = neighbourhood(inputs.denoised, x, y);
      const Vector3d clamped = toYCoCg(history).cwiseMax(bounds.low).cwiseMin(bounds.high);
      const bool slow = std::abs(prev.x - x) <= 8.0 && std::abs(prev.y - y) <= 8.0;
      const bool steady = prev.silhouette && slow && accepted >= 5;
      const double weight = steady ? inputs.silhouetteWeight : inputs.newestWeight;
      color = weight * color + (1.0 - weight) * toRgb(clamped);
    }
    color = color.cwiseMax(0.0).cwiseMin(QUELL_MAX_RADIANCE);
    for (int c = 0; c < 3; ++c) antialiased.at(c, x, y) = color[c];
  });
  return antialiased;
}

}  // namespace quell::tests

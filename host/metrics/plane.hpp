// One channel in double precision and separable convolution of it: what the windowed measures are made of.
#pragma once

#include <cstddef>
#include <vector>

#include "host/io/image.hpp"

namespace quell::metrics {

/// Row-major: at(x, y) = values[y * width + x].
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<double> values;

  Plane() = default;
  Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}

  double& at(int x, int y) { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  double at(int x, int y) const { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

/// An odd number of taps; the middle one lies on the pixel.
using Kernel = std::vector<double>;

/// exp(-x^2 / (2 sigmaPx^2)) at x = -radiusPx .. radiusPx, scaled to a sum of one.
Kernel gaussianKernel(double sigmaPx, int radiusPx);

/// out(x, y) = sum over i, j of kernelX[i] kernelY[j] in(x + i - rx, y + j - ry), r the kernels' radii.
/// Pixels outside the image repeat the nearest one inside.
Plane convolve(const Plane& in, const Kernel& kernelX, const Kernel& kernelY);

/// a * b, element by element; both of one size.
Plane multiply(const Plane& a, const Plane& b);

/// Rec. 709 luma of a 3-channel encoded image.
Plane lumaPlane(const io::Image& encoded);

}  // namespace quell::metrics

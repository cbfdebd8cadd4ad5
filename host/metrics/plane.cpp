#include "host/metrics/plane.hpp"

#include <algorithm>
#include <cmath>

#include "host/metrics/display_encoding.hpp"

namespace quell::metrics {
namespace {

Plane convolveRows(const Plane& in, const Kernel& kernel) {
  const int radius = int(kernel.size()) / 2;
  Plane out(in.width, in.height);
  Plane padded(in.width + 2 * radius, 1);
  for (int y = 0; y < in.height; ++y) {
    for (int x = 0; x < padded.width; ++x)
      padded.at(x, 0) = in.at(std::clamp(x - radius, 0, in.width - 1), y);
    for (std::size_t tap = 0; tap < kernel.size(); ++tap)
      for (int x = 0; x < in.width; ++x) out.at(x, y) += kernel[tap] * padded.at(x + int(tap), 0);
  }
  return out;
}

Plane convolveColumns(const Plane& in, const Kernel& kernel) {
  const int radius = int(kernel.size()) / 2;
  Plane out(in.width, in.height);
  for (int y = 0; y < in.height; ++y)
    for (std::size_t tap = 0; tap < kernel.size(); ++tap) {
      const int source = std::clamp(y + int(tap) - radius, 0, in.height - 1);
      for (int x = 0; x < in.width; ++x) out.at(x, y) += kernel[tap] * in.at(x, source);
    }
  return out;
}

}  // namespace

Kernel gaussianKernel(double sigmaPx, int radiusPx) {
  Kernel kernel;
  double sum = 0.0;
  for (int x = -radiusPx; x <= radiusPx; ++x) {
    kernel.push_back(std::exp(-double(x * x) / (2.0 * sigmaPx * sigmaPx)));
    sum += kernel.back();
  }
  for (double& tap : kernel) tap /= sum;
  return kernel;
}

Plane convolve(const Plane& in, const Kernel& kernelX, const Kernel& kernelY) {
  return convolveColumns(convolveRows(in, kernelX), kernelY);
}

Plane multiply(const Plane& a, const Plane& b) {
  Plane product = a;
  for (std::size_t i = 0; i < product.values.size(); ++i) product.values[i] *= b.values[i];
  return product;
}

Plane lumaPlane(const io::Image& encoded) {
  Plane plane(encoded.width, encoded.height);
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x)
      plane.at(x, y) =
          luma(double(encoded.at(x, y, 0)), double(encoded.at(x, y, 1)), double(encoded.at(x, y, 2)));
  return plane;
}

}  // namespace quell::metrics

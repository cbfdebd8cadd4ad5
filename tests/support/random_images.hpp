// Seeded random inputs, the same on every platform, and values that break careless code.
#pragma once

#include <random>
#include <vector>

#include "host/io/image.hpp"
#include "tests/support/planes.hpp"

namespace quell::tests {

/// Uniform numbers; std::uniform_real_distribution differs between standard libraries.
class Random {
 public:
  explicit Random(unsigned seed) : m_generator(seed) {}
  double uniform(double low = 0.0, double high = 1.0) {
    return low + (high - low) * double(m_generator()) / double(std::mt19937::max());
  }
  int integer(int low, int high);  ///< both included

 private:
  std::mt19937 m_generator;
};

Planes randomPlanes(Size size, int count, unsigned seed, double low = 0.0, double high = 1.0);
io::Image randomImage(Size size, int channels, unsigned seed, double low = 0.0, double high = 1.0);

/// NaN, infinities, negative numbers, numbers beyond half, denormals and numbers whose square is a denormal.
const std::vector<float>& adversarialValues();

/// Puts adversarial values into about one pixel in `every`, and marks those pixels.
void spoil(io::Image& image, unsigned seed, int every, BasicPlanes<char>* marks = nullptr);

/// Pixel positions in the frame before, multiples of 1/256 around each pixel, and a mask that fits them:
/// every bit of a tap that lies in the image is random.
struct RandomMotion {
  Planes pixelPrev;         ///< 2 planes
  Planes reprojectionMask;  ///< 1 plane
};
RandomMotion randomMotion(Size size, unsigned seed, double amplitudePx = 3.0);

}  // namespace quell::tests

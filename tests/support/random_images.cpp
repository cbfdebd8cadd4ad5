#include "tests/support/random_images.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/accumulate_noisy_params.h"

namespace quell::tests {
namespace {

bool tapInFrame(Size size, double x, double y, int tap) {
  const int column = int(std::floor(x)) + tap % 2;
  const int row = int(std::floor(y)) + tap / 2;
  return column >= 0 && column < size.width && row >= 0 && row < size.height;
}

int randomMask(Random& random, Size size, double x, double y) {
  int mask = QUELL_PREV_IN_FRAME;
  if (random.uniform() < 0.6)
    return mask | QUELL_HISTORY_REJECTED;  // so often that all neighbours are, now and then
  for (int tap = 0; tap < 4; ++tap)
    if (tapInFrame(size, x, y, tap) && random.uniform() < 0.8) mask |= QUELL_TAP_ACCEPTED(tap);
  return mask;
}

}  // namespace

int Random::integer(int low, int high) {
  return std::min(high, low + int(uniform() * double(high - low + 1)));
}

Planes randomPlanes(Size size, int count, unsigned seed, double low, double high) {
  Random random(seed);
  Planes planes(size, count);
  for (float& value : planes.values) value = float(random.uniform(low, high));
  return planes;
}

io::Image randomImage(Size size, int channels, unsigned seed, double low, double high) {
  Random random(seed);
  io::Image image(size.width, size.height, channels);
  for (float& value : image.pixels) value = float(random.uniform(low, high));
  return image;
}

const std::vector<float>& adversarialValues() {
  using Limits = std::numeric_limits<float>;
  static const std::vector<float> values = {
      Limits::quiet_NaN(),
      Limits::infinity(),
      -Limits::infinity(),
      Limits::max(),
      -Limits::max(),
      -1.0f,
      -0.0f,
      Limits::denorm_min(),
      1e-41f,
      1e-30f,
      2e-22f,
      1e-9f,
      65504.0f,
      65536.0f,
      1e19f,
  };
  return values;
}

void spoil(io::Image& image, unsigned seed, int every, BasicPlanes<char>* marks) {
  Random random(seed);
  const auto& values = adversarialValues();
  forEachPixel({image.width, image.height}, [&](int x, int y) {
    if (random.integer(1, every) != 1) return;
    const float value = values[std::size_t(random.integer(0, int(values.size()) - 1))];
    const int channel = random.integer(0, image.channels);  // one past the end: all of them
    for (int c = 0; c < image.channels; ++c)
      if (c == channel || channel == image.channels) image.at(x, y, c) = value;
    if (marks != nullptr) marks->at(0, x, y) = 1;
  });
}

RandomMotion randomMotion(Size size, unsigned seed, double amplitudePx) {
  Random random(seed);
  RandomMotion motion{Planes(size, 2), Planes(size, 1)};
  const auto place = [&](int pixel) {
    const double moved = pixel + amplitudePx * random.uniform(-1.0, 1.0);
    return std::floor(moved * QUELL_SUBPIXEL_STEPS) / QUELL_SUBPIXEL_STEPS;
  };
  forEachPixel(size, [&](int x, int y) {
    const double xPrev = place(x);
    const double yPrev = place(y);
    if (xPrev <= -1.0 || xPrev >= size.width || yPrev <= -1.0 || yPrev >= size.height) return;  // 0: outside
    motion.pixelPrev.at(0, x, y) = float(xPrev);
    motion.pixelPrev.at(1, x, y) = float(yPrev);
    motion.reprojectionMask.at(0, x, y) = float(randomMask(random, size, xPrev, yPrev));
  });
  return motion;
}

}  // namespace quell::tests

// Bilinear taps, plainly.
#pragma once

#include <array>
#include <cmath>

#include "tests/support/planes.hpp"

namespace quell::tests {

struct Tap {
  int index;  ///< in the order (0,0) (1,0) (0,1) (1,1)
  int x, y;
  double weight;
  bool inFrame;
};

/// The four pixels around pixel index (x, y).
inline std::array<Tap, 4> bilinearTaps(Size size, double x, double y) {
  const double left = std::floor(x), top = std::floor(y);
  std::array<Tap, 4> taps;
  for (int i = 0; i < 4; ++i) {
    const int column = int(left) + i % 2, row = int(top) + i / 2;
    const double weightX = i % 2 == 1 ? x - left : 1.0 - (x - left);
    const double weightY = i / 2 == 1 ? y - top : 1.0 - (y - top);
    taps[std::size_t(i)] = {i, column, row, weightX * weightY,
                            column >= 0 && column < size.width && row >= 0 && row < size.height};
  }
  return taps;
}

}  // namespace quell::tests

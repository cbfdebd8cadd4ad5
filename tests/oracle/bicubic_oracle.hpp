// Catmull-Rom taps, plainly.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/planes.hpp"

namespace quell::tests {

struct CubicTap {
  int x, y;
  double weight;
};

/// Catmull and Rom's kernel with tension 1/2 at a distance in pixels.
inline double catmullRom(double distance) {
  const double d = std::abs(distance);
  if (d < 1.0) return 1.0 - 2.5 * d * d + 1.5 * d * d * d;
  return d < 2.0 ? 2.0 - 4.0 * d + 2.5 * d * d - 0.5 * d * d * d : 0.0;
}

/// The pixels of the frame that count at pixel index (x, y), moved to the border if it lies outside: those less than two
/// columns and rows away, without the four corners, which are more than one away in both.
inline std::vector<CubicTap> bicubicTaps(Size size, double x, double y) {
  const double insideX = std::clamp(x, 0.0, size.width - 1.0),
               insideY = std::clamp(y, 0.0, size.height - 1.0);
  std::vector<CubicTap> taps;
  for (int row = std::max(int(insideY) - 1, 0); row <= std::min(int(insideY) + 2, size.height - 1); ++row) {
    for (int column = std::max(int(insideX) - 1, 0); column <= std::min(int(insideX) + 2, size.width - 1);
         ++column) {
      const double dx = column - insideX, dy = row - insideY;
      const bool corner = std::abs(dx) > 1.0 && std::abs(dy) > 1.0;
      const double weight = corner ? 0.0 : catmullRom(dx) * catmullRom(dy);
      if (weight != 0.0) taps.push_back({column, row, weight});
    }
  }
  return taps;
}

}  // namespace quell::tests

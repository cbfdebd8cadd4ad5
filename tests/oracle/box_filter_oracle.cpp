#include "tests/oracle/box_filter_oracle.hpp"

#include <cmath>

namespace quell::tests {

BoxFilterExact boxFilterOracle(const Planes& planes, int radius, bool alongRows) {
  const Size size = planes.size();
  BoxFilterExact exact{ExactPlanes(size, planes.count), ExactPlanes(size, planes.count)};
  for (int plane = 0; plane < planes.count; ++plane) {
    forEachPixel(size, [&](int x, int y) {
      for (int step = -radius; step <= radius; ++step) {
        const int column = x + (alongRows ? step : 0);
        const int row = y + (alongRows ? 0 : step);
        if (column < 0 || row < 0 || column >= size.width || row >= size.height) continue;
        exact.sums.at(plane, x, y) += planes.at(plane, column, row);
        exact.magnitudes.at(plane, x, y) += std::abs(planes.at(plane, column, row));
      }
    });
  }
  return exact;
}

}  // namespace quell::tests

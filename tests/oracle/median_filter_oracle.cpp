#include "tests/oracle/median_filter_oracle.hpp"

#include <algorithm>
#include <vector>

namespace quell::tests {

ExactPlanes medianFilterOracle(const Planes& planes, const Planes& weights) {
  const Size size = planes.size();
  ExactPlanes medians(size, planes.count);
  for (int plane = 0; plane < planes.count; ++plane) {
    forEachPixel(size, [&](int x, int y) {
      std::vector<double> values;
      for (int row = y - 1; row <= y + 1; ++row) {
        for (int column = x - 1; column <= x + 1; ++column) {
          const bool inside = column >= 0 && row >= 0 && column < size.width && row < size.height;
          const bool counts = inside && weights.at(0, column, row) > 0.0f;
          values.push_back(counts ? planes.at(plane, column, row) : planes.at(plane, x, y));
        }
      }
      std::nth_element(values.begin(), values.begin() + 4, values.end());
      medians.at(plane, x, y) = values[4];
    });
  }
  return medians;
}

}  // namespace quell::tests

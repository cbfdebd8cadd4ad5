#include "tests/oracle/light_sums_oracle.hpp"

#include <algorithm>

#include "kernels/common/guides.h"
#include "tests/oracle/edge_stops_oracle.hpp"

namespace quell::tests {

LightSumsExact lightSumsOracle(const LightSumsInputs& inputs) {
  const Size size = inputs.filtered.size();
  const TileGrid grid(size);
  const Size records{grid.count() * inputs.signals() * QUELL_LIGHT_RECORD, 1};
  LightSumsExact exact{ExactPlanes(records, 1), ExactPlanes(records, 1)};
  ExactPlanes left({grid.count() * inputs.signals(), 1}, 1);
  for (int signal = 0; signal < inputs.signals(); ++signal) {
    forEachPixel(size, [&](int x, int y) {
      if (y % 2 != 0) return;
      const double weight = inputs.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y);
      const auto channel = [&](int c) { return double(inputs.filtered.at(3 * signal + c, x, y)); };
      const double history = inputs.stopLuminance.at(signal, x, y);
      const double filtered = luminanceOf(channel(0), channel(1), channel(2));
      left.at(0, signal * grid.count() + grid.tileAt(x, y), 0) += weight * filtered;
      const int record = (signal * grid.count() + grid.tileAt(x, y)) * QUELL_LIGHT_RECORD;
      const auto add = [&](int i, double value, double magnitude) {
        exact.sums.at(0, record + i, 0) += weight * value;
        exact.magnitudes.at(0, record + i, 0) += weight * magnitude;
      };
      add(QUELL_LIGHT_LOST, history - filtered, history + filtered);
      add(QUELL_LIGHT_SQUARES, filtered * filtered, filtered * filtered);
    });
  }
  for (std::size_t tile = 0; tile < left.values.size(); ++tile) {
    double& lost = exact.sums.values[tile * QUELL_LIGHT_RECORD + QUELL_LIGHT_LOST];
    lost = std::min(lost, 2.0 * left.values[tile]);
  }
  return exact;
}

}  // namespace quell::tests

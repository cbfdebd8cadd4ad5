#include "tests/oracle/change_sums_oracle.hpp"

#include <cmath>

namespace quell::tests {
namespace {

constexpr double kLeastComparedLength = 2.0;  // frames: the newest one and one before

}  // namespace

ChangeSumsExact changeSumsOracle(const ChangeSumsInputs& inputs) {
  const Size size = inputs.innovation.size();
  const TileGrid grid(size);
  const Size records{grid.count() * inputs.signals() * QUELL_CHANGE_RECORD, 1};
  ChangeSumsExact exact{ExactPlanes(records, 1), ExactPlanes(records, 1)};
  for (int signal = 0; signal < inputs.signals(); ++signal) {
    forEachPixel(size, [&](int x, int y) {
      if (inputs.historyLength.at(signal, x, y) < kLeastComparedLength) return;
      const int record = (signal * grid.count() + grid.tileAt(x, y)) * QUELL_CHANGE_RECORD;
      const double luminance =
          inputs.innovation.at(QUELL_INNOVATION_PLANES * signal + QUELL_INNOVATION_LUMINANCE, x, y);
      const double chrominance =
          inputs.innovation.at(QUELL_INNOVATION_PLANES * signal + QUELL_INNOVATION_CHROMINANCE, x, y);
      double terms[QUELL_CHANGE_RECORD] = {};
      terms[QUELL_CHANGE_COUNT] = 1.0;
      terms[QUELL_CHANGE_SUM(QUELL_INNOVATION_LUMINANCE)] = luminance;
      terms[QUELL_CHANGE_SQUARES(QUELL_INNOVATION_LUMINANCE)] = luminance * luminance;
      terms[QUELL_CHANGE_SUM(QUELL_INNOVATION_CHROMINANCE)] = chrominance;
      terms[QUELL_CHANGE_SQUARES(QUELL_INNOVATION_CHROMINANCE)] = chrominance * chrominance;
      for (int i = 0; i < QUELL_CHANGE_RECORD; ++i) {
        exact.sums.at(0, record + i, 0) += terms[i];
        exact.magnitudes.at(0, record + i, 0) += std::abs(terms[i]);
      }
    });
  }
  for (std::size_t i = 0; i < exact.sums.values.size(); ++i) {
    const double kept = inputs.sumsKept * inputs.sumsPrev.values[i];
    exact.sums.values[i] += kept;
    exact.magnitudes.values[i] += std::abs(kept);
  }
  return exact;
}

}  // namespace quell::tests

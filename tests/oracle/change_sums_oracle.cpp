#include "tests/oracle/change_sums_oracle.hpp"

#include <algorithm>
#include <cmath>

namespace quell::tests {
namespace {

constexpr double kLeastComparedLength = 2.0;  // frames: the newest one and one before

// How well the differences of a tile agree with those of their neighbours.
class AgreementOracle {
 public:
  AgreementOracle(const ChangeSumsInputs& inputs, int signal, int column, int row)
      : m_inputs(inputs), m_signal(signal), m_left(column * QUELL_TILE), m_top(row * QUELL_TILE) {}

  double odds() const {
    double pixels = 0.0;
    forEachPixel({QUELL_TILE, QUELL_TILE}, [&](int x, int y) { pixels += compared(x, y); });
    if (pixels < QUELL_CHANGE_AGREED_PIXELS * double(QUELL_TILE * QUELL_TILE)) return 0.0;
    return std::max(oddsOfPairs(1, 0), oddsOfPairs(0, 1));
  }

 private:
  bool compared(int x, int y) const {
    const Size size = m_inputs.historyLength.size();
    if (x >= QUELL_TILE || y >= QUELL_TILE || m_left + x >= size.width || m_top + y >= size.height)
      return false;
    return m_inputs.historyLength.at(m_signal, m_left + x, m_top + y) >= kLeastComparedLength;
  }

  double luminance(int x, int y) const {
    return m_inputs.innovation.at(QUELL_INNOVATION_PLANES * m_signal + QUELL_INNOVATION_LUMINANCE, m_left + x,
                                  m_top + y);
  }

  double oddsOfPairs(int dx, int dy) const {
    double all = 0.0, agreed = 0.0;
    forEachPixel({QUELL_TILE, QUELL_TILE}, [&](int x, int y) {
      if (!compared(x, y) || !compared(x + dx, y + dy)) return;
      const double a = luminance(x, y), b = luminance(x + dx, y + dy);
      const double size = a * a + b * b;
      const double apart = std::pow((a - b) / double(QUELL_CHANGE_AGREED_SHARE), 2.0);
      all += size;
      agreed += size * size / (size + apart + double(QUELL_CHANGE_LEAST_SPREAD));
    });
    const double chance = agreed / std::max(all, double(QUELL_CHANGE_LEAST_SPREAD));
    return chance / std::max(1.0 - chance, double(QUELL_CHANGE_LEAST_DOUBT));
  }

  const ChangeSumsInputs& m_inputs;
  int m_signal, m_left, m_top;
};

void addAgreements(const ChangeSumsInputs& inputs, const TileGrid& grid, ChangeSumsExact& exact) {
  for (int signal = 0; signal < inputs.signals(); ++signal)
    forEachPixel({grid.columns, grid.rows}, [&](int column, int row) {
      const double odds = AgreementOracle(inputs, signal, column, row).odds();
      const int tile = signal * grid.count() + row * grid.columns + column;
      exact.sums.at(0, tile * QUELL_CHANGE_RECORD + QUELL_CHANGE_AGREEMENT, 0) = odds;
      // A chance is known to the rounding of floats: odds of it to the square of one and the odds.
      exact.magnitudes.at(0, tile * QUELL_CHANGE_RECORD + QUELL_CHANGE_AGREEMENT, 0) =
          std::pow(1.0 + odds, 2.0);
    });
}

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
  addAgreements(inputs, grid, exact);
  return exact;
}

}  // namespace quell::tests

#include "tests/oracle/change_weight_oracle.hpp"

#include <algorithm>
#include <cmath>

namespace quell::tests {
namespace {

constexpr double kPixelsOfTile = double(QUELL_CHANGE_TILE) * QUELL_CHANGE_TILE;

// The largest weight that a window around the tile gives.
class WindowOracle {
 public:
  WindowOracle(const ChangeWeightInputs& inputs, int signal, int column, int row)
      : m_inputs(inputs), m_grid(inputs.size), m_signal(signal), m_column(column), m_row(row) {}

  double weight(int radius) const {
    double pixels = 0.0, allPixels = 0.0, sum = 0.0, squares = 0.0, shareSquares = 0.0;
    forEachTile(radius, [&](const float* record, double tent) {
      pixels += tent * record[QUELL_CHANGE_COUNT];
      allPixels += tent * kPixelsOfTile;
      sum += tent * record[QUELL_CHANGE_SUM];
      squares += tent * record[QUELL_CHANGE_SQUARES];
    });
    if (pixels < double(QUELL_CHANGE_LEAST_SHARE) * allPixels) return 0.0;
    // Each pixel's share in the mean, squared.
    forEachTile(radius, [&](const float* record, double tent) {
      shareSquares += std::pow(tent / pixels, 2.0) * record[QUELL_CHANGE_COUNT];
    });
    const double mean = sum / pixels;
    const double spread = std::max<double>(squares / pixels - mean * mean, QUELL_CHANGE_LEAST_SPREAD);
    const double bias = mean * mean / (spread * shareSquares) - m_inputs.threshold * m_inputs.threshold;
    return bias > 0.0 ? m_inputs.mostWeight / (1.0 + m_inputs.gain / bias) : 0.0;
  }

 private:
  template <class Work>
  void forEachTile(int radius, const Work& work) const {
    for (int row = std::max(0, m_row - radius); row <= std::min(m_grid.rows - 1, m_row + radius); ++row) {
      for (int column = std::max(0, m_column - radius);
           column <= std::min(m_grid.columns - 1, m_column + radius); ++column) {
        const int tile = m_signal * m_grid.count() + row * m_grid.columns + column;
        const double tent =
            (radius + 1.0 - std::abs(row - m_row)) * (radius + 1.0 - std::abs(column - m_column));
        work(&m_inputs.sums.values[std::size_t(tile) * QUELL_CHANGE_RECORD], tent);
      }
    }
  }

  const ChangeWeightInputs& m_inputs;
  TileGrid m_grid;
  int m_signal, m_column, m_row;
};

}  // namespace

ExactPlanes changeWeightOracle(const ChangeWeightInputs& inputs) {
  const TileGrid grid(inputs.size);
  ExactPlanes weights({grid.count() * inputs.signals, 1}, 1);
  for (int signal = 0; signal < inputs.signals; ++signal) {
    forEachPixel({grid.columns, grid.rows}, [&](int column, int row) {
      const WindowOracle window(inputs, signal, column, row);
      weights.at(0, signal * grid.count() + row * grid.columns + column, 0) =
          std::max(window.weight(QUELL_CHANGE_SMALL_WINDOW), window.weight(QUELL_CHANGE_LARGE_WINDOW));
    });
  }
  return weights;
}

}  // namespace quell::tests

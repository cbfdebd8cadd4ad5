#include "tests/oracle/light_gain_oracle.hpp"

#include <algorithm>
#include <cmath>

namespace quell::tests {
namespace {

constexpr int kWindow = 5;  // tiles on either side

struct Gain {
  double value, magnitude;
};

Gain gainAt(const LightGainInputs& inputs, const TileGrid& grid, int signal, int column, int row) {
  double lost = 0.0, lostMagnitude = 0.0, lostSquares = 0.0, squares = 0.0;
  for (int y = std::max(0, row - kWindow); y <= std::min(grid.rows - 1, row + kWindow); ++y) {
    for (int x = std::max(0, column - kWindow); x <= std::min(grid.columns - 1, column + kWindow); ++x) {
      const double tent = (kWindow + 1.0 - std::abs(y - row)) * (kWindow + 1.0 - std::abs(x - column));
      const int tile = signal * grid.count() + y * grid.columns + x;
      const float* record = &inputs.sums.values[std::size_t(tile) * QUELL_LIGHT_RECORD];
      lost += tent * record[QUELL_LIGHT_LOST];
      lostMagnitude += tent * std::abs(record[QUELL_LIGHT_LOST]);
      lostSquares += std::pow(tent * record[QUELL_LIGHT_LOST], 2.0);
      squares += tent * record[QUELL_LIGHT_SQUARES];
    }
  }
  if (squares <= 0.0 || lost == 0.0) return {0.0, 0.0};
  const double sure = std::max(0.0, 1.0 - lostSquares / (lost * lost));
  return {sure * lost / squares, lostMagnitude / squares};
}

}  // namespace

LightGainExact lightGainOracle(const LightGainInputs& inputs) {
  const TileGrid grid(inputs.size);
  const Size size{grid.count() * inputs.signals, 1};
  LightGainExact exact{ExactPlanes(size, 1), ExactPlanes(size, 1)};
  for (int signal = 0; signal < inputs.signals; ++signal) {
    forEachPixel({grid.columns, grid.rows}, [&](int column, int row) {
      const Gain gain = gainAt(inputs, grid, signal, column, row);
      const int tile = signal * grid.count() + row * grid.columns + column;
      exact.gains.at(0, tile, 0) = gain.value;
      exact.magnitudes.at(0, tile, 0) = gain.magnitude;
    });
  }
  return exact;
}

double lightRatio(double gain, double luminance) { return std::clamp(1.0 + gain * luminance, 0.5, 2.0); }

}  // namespace quell::tests

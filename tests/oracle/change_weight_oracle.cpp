#include "tests/oracle/change_weight_oracle.hpp"

#include <algorithm>
#include <cmath>

namespace quell::tests {
namespace {

constexpr double kPixelsOfTile = double(QUELL_TILE) * QUELL_TILE;

// What windows around the tile tell.
class WindowOracle {
 public:
  WindowOracle(const ChangeWeightInputs& inputs, int signal, int column, int row)
      : m_inputs(inputs), m_grid(inputs.size), m_signal(signal), m_column(column), m_row(row) {}

  double significance(int radius) const {
    double pixels = 0.0, allPixels = 0.0, shareSquares = 0.0;
    forEachTile(radius, [&](const float* record, double tent) {
      pixels += tent * record[QUELL_CHANGE_COUNT];
      allPixels += tent * kPixelsOfTile;
    });
    if (pixels < double(QUELL_CHANGE_LEAST_SHARE) * allPixels) return 0.0;
    // Each pixel's share in the mean, squared.
    forEachTile(radius, [&](const float* record, double tent) {
      shareSquares += std::pow(tent / pixels, 2.0) * record[QUELL_CHANGE_COUNT];
    });
    const Moments luminance = moments(radius, QUELL_INNOVATION_LUMINANCE);
    const Moments chrominance = moments(radius, QUELL_INNOVATION_CHROMINANCE);
    const double spread = std::max<double>(luminance.spread, QUELL_CHANGE_LEAST_SPREAD);
    const double chrominanceSpread = std::max({chrominance.spread, double(QUELL_CHANGE_LEAST_SPREAD),
                                               double(QUELL_CHANGE_LEAST_CHROMINANCE) * spread});
    return std::max(luminance.mean * luminance.mean / spread,
                    chrominance.mean * chrominance.mean / chrominanceSpread) /
           shareSquares;
  }

  double agreement() const {
    const int tile = m_signal * m_grid.count() + m_row * m_grid.columns + m_column;
    return m_inputs.sums.values[std::size_t(tile) * QUELL_CHANGE_RECORD + QUELL_CHANGE_AGREEMENT];
  }

  double recentChangeBefore() const {
    double sum = 0.0;
    for (const int dy : {-1, 0, 0, 1}) {  // the tent's weights, counted
      for (const int dx : {-1, 0, 0, 1}) {
        const int row = std::clamp(m_row + dy, 0, m_grid.rows - 1);
        const int column = std::clamp(m_column + dx, 0, m_grid.columns - 1);
        sum += double(
            m_inputs.recentChangePrev.at(0, m_signal * m_grid.count() + row * m_grid.columns + column, 0));
      }
    }
    return sum / 16.0;
  }

 private:
  struct Moments {
    double mean, spread;
  };

  Moments moments(int radius, int plane) const {
    double pixels = 0.0, sum = 0.0, squares = 0.0;
    forEachTile(radius, [&](const float* record, double tent) {
      pixels += tent * record[QUELL_CHANGE_COUNT];
      sum += tent * record[QUELL_CHANGE_SUM(plane)];
      squares += tent * record[QUELL_CHANGE_SQUARES(plane)];
    });
    const double mean = sum / pixels;
    return {mean, squares / pixels - mean * mean};
  }

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

double weightOf(const ChangeWeightInputs& inputs, double significance, double recentChange) {
  const double still = double(QUELL_RECENT_CHANGE_NONE), changing = double(QUELL_RECENT_CHANGE_SURE);
  const double share = std::clamp((recentChange - still) / (changing - still), 0.0, 1.0);
  const double threshold =
      (1.0 - share) * std::pow(inputs.threshold, 2.0) + share * std::pow(inputs.recentChangeThreshold, 2.0);
  const double bias = significance - threshold;
  return bias > 0.0 ? inputs.mostWeight / (1.0 + inputs.gain / bias) : 0.0;
}

}  // namespace

ChangeWeightExact changeWeightOracle(const ChangeWeightInputs& inputs) {
  const TileGrid grid(inputs.size);
  const Size size{grid.count() * inputs.signals, 1};
  ChangeWeightExact exact{ExactPlanes(size, 1), ExactPlanes(size, 1)};
  for (int signal = 0; signal < inputs.signals; ++signal) {
    forEachPixel({grid.columns, grid.rows}, [&](int column, int row) {
      const WindowOracle window(inputs, signal, column, row);
      const double significance =
          std::max({window.significance(QUELL_CHANGE_SMALL_WINDOW),
                    window.significance(QUELL_CHANGE_LARGE_WINDOW), window.agreement()});
      const double newest = std::min(significance, double(QUELL_RECENT_CHANGE_MOST));
      const double kept = inputs.restarted ? 0.0 : double(QUELL_RECENT_CHANGE_KEPT);
      const double recentChange = kept * window.recentChangeBefore() + (1.0 - kept) * newest;
      const int tile = signal * grid.count() + row * grid.columns + column;
      exact.recentChange.at(0, tile, 0) = recentChange;
      exact.weights.at(0, tile, 0) = weightOf(inputs, significance, recentChange);
    });
  }
  return exact;
}

}  // namespace quell::tests

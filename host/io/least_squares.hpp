// Linear least squares of a few unknowns.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace quell::io {

/// Normal equations, which are solved by elimination: for well-scaled unknowns.
template <std::size_t Unknowns>
class LeastSquares {
 public:
  using Row = std::array<double, Unknowns + 1>;  ///< coefficients, then the right side

  void add(const Row& row, double weight = 1.0) {
    for (std::size_t i = 0; i < Unknowns; ++i)
      for (std::size_t j = 0; j <= Unknowns; ++j) m_rows[i][j] += weight * row[i] * row[j];
  }

  /// Nothing where the rows do not tell.
  std::optional<std::array<double, Unknowns>> solve() {
    double first = 0.0;
    for (std::size_t column = 0; column < Unknowns; ++column) {
      const auto pivot = std::max_element(
          m_rows.begin() + std::ptrdiff_t(column), m_rows.end(),
          [column](const Row& a, const Row& b) { return std::abs(a[column]) < std::abs(b[column]); });
      std::swap(*pivot, m_rows[column]);
      const double size = std::abs(m_rows[column][column]);
      first = std::max(first, size);
      if (!(size > kLeastPivot * first)) return std::nullopt;  // true for NaN
      for (std::size_t row = 0; row < Unknowns; ++row) {
        if (row == column) continue;
        const double factor = m_rows[row][column] / m_rows[column][column];
        for (std::size_t i = column; i <= Unknowns; ++i) m_rows[row][i] -= factor * m_rows[column][i];
      }
    }
    std::array<double, Unknowns> solution;
    for (std::size_t i = 0; i < Unknowns; ++i) solution[i] = m_rows[i][Unknowns] / m_rows[i][i];
    return solution;
  }

 private:
  /// Pivots below this share of the first are those of a system that does not tell.
  static constexpr double kLeastPivot = 1e-10;

  std::array<Row, Unknowns> m_rows{};
};

}  // namespace quell::io

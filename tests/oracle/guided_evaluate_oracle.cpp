#include "tests/oracle/guided_evaluate_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/common/guides.h"
#include "tests/oracle/guided_moments_oracle.hpp"

namespace quell::tests {
namespace {

// A plane of cells, interpolated bilinearly between their centres; those outside the grid count as 0.
double interpolate(const Planes& cells, int plane, int subsampling, int x, int y) {
  const double u = (x + 0.5) / subsampling - 0.5;
  const double v = (y + 0.5) / subsampling - 0.5;
  const int left = int(std::floor(u)), top = int(std::floor(v));
  double sum = 0.0;
  for (int row = top; row <= top + 1; ++row) {
    for (int column = left; column <= left + 1; ++column) {
      if (column < 0 || row < 0 || column >= cells.width || row >= cells.height) continue;
      const double weight = (1.0 - std::abs(u - column)) * (1.0 - std::abs(v - row));
      sum += weight * cells.at(plane, column, row);
    }
  }
  return sum;
}

}  // namespace

GuidedEvaluateExact guidedEvaluateOracle(const GuidedEvaluateInputs& inputs) {
  const Size size = inputs.guides.size();
  GuidedEvaluateExact exact{ExactPlanes(size, 3 * inputs.signals()), ExactPlanes(size, 3 * inputs.signals())};
  forEachPixel(size, [&](int x, int y) {
    std::array<double, QUELL_GUIDED_FEATURES> guide{1.0};
    for (int axis = 0; axis < 3; ++axis)
      guide[std::size_t(1 + axis)] = inputs.guides.at(QUELL_GUIDE_NORMAL + axis, x, y);
    if (guide[1] == 0.0 && guide[2] == 0.0 && guide[3] == 0.0) return;
    guide[QUELL_GUIDED_DEPTH] = inputs.viewDepth.at(0, x, y);
    for (int plane = 0; plane < 3 * inputs.signals(); ++plane) {
      const int first = plane / 3 * QUELL_GUIDED_COEFFICIENTS;
      const auto at = [&](int k) {
        return interpolate(inputs.windowCoefficients, first + k, inputs.subsampling, x, y);
      };
      const double windows = at(QUELL_GUIDED_USED);
      if (windows <= 0.0) continue;
      double sum = 0.0, magnitude = 0.0;
      for (int j = 0; j < QUELL_GUIDED_FEATURES; ++j) {
        const double term = guide[std::size_t(j)] * at(QUELL_GUIDED_CHANNELS * j + plane % 3) / windows;
        sum += term;
        magnitude += std::abs(term);
      }
      exact.irradiance.at(plane, x, y) = std::clamp(sum, 0.0, double(QUELL_MAX_RADIANCE));
      exact.magnitudes.at(plane, x, y) = magnitude;
    }
  });
  return exact;
}

}  // namespace quell::tests

#include "tests/oracle/guided_moments_oracle.hpp"

#include <array>
#include <cmath>

#include "kernels/common/guides.h"
#include "kernels/guided_params.h"

namespace quell::tests {
namespace {

constexpr int kColumns = QUELL_GUIDED_FEATURES + QUELL_GUIDED_CHANNELS;

// 1, normal, depth, colour.
std::array<double, kColumns> columnsAt(const GuidedMomentsInputs& inputs, int signal, int x, int y) {
  std::array<double, kColumns> columns{};
  columns[0] = 1.0;
  for (int axis = 0; axis < 3; ++axis)
    columns[std::size_t(1 + axis)] = inputs.guides.at(QUELL_GUIDE_NORMAL + axis, x, y);
  columns[QUELL_GUIDED_DEPTH] = inputs.viewDepth.at(0, x, y);
  for (int c = 0; c < QUELL_GUIDED_CHANNELS; ++c)
    columns[std::size_t(QUELL_GUIDED_FEATURES + c)] = inputs.irradiance.at(3 * signal + c, x, y);
  return columns;
}

}  // namespace

Size cellsOf(Size size, int subsampling) {
  const auto along = [&](int pixels) { return (pixels + subsampling - 1) / subsampling; };
  return {along(size.width), along(size.height)};
}

GuidedMomentsExact guidedMomentsOracle(const GuidedMomentsInputs& inputs) {
  const Size size = inputs.guides.size();
  const Size cells = cellsOf(size, inputs.subsampling);
  const int planes = QUELL_GUIDED_SUMS * inputs.signals();
  GuidedMomentsExact exact{ExactPlanes(cells, planes), ExactPlanes(cells, planes)};
  for (int signal = 0; signal < inputs.signals(); ++signal) {
    forEachPixel(size, [&](int x, int y) {
      const auto columns = columnsAt(inputs, signal, x, y);
      const double weight = inputs.guides.at(QUELL_GUIDE_WEIGHT + signal, x, y);
      int plane = QUELL_GUIDED_SUMS * signal;
      for (std::size_t a = 0; a < QUELL_GUIDED_FEATURES; ++a) {
        for (std::size_t b = a; b < kColumns; ++b, ++plane) {
          const double product = weight * columns[a] * columns[b];
          exact.sums.at(plane, x / inputs.subsampling, y / inputs.subsampling) += product;
          exact.magnitudes.at(plane, x / inputs.subsampling, y / inputs.subsampling) += std::abs(product);
        }
      }
    });
  }
  return exact;
}

}  // namespace quell::tests

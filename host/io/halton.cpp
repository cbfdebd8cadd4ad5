#include "host/io/halton.hpp"

namespace quell::io {
namespace {

// The digits of `index` mirrored at the point.
double radicalInverse(int index, int base) {
  double result = 0.0, digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) result += digit * (index % base);
  return result;
}

}  // namespace

std::array<double, 2> halton23(int index) { return {radicalInverse(index, 2), radicalInverse(index, 3)}; }

std::array<double, 2> jitterPxOf(int frame) {
  const auto [x, y] = halton23(1 + frame % kJitterPeriod);
  return {x - 0.5, y - 0.5};
}

}  // namespace quell::io

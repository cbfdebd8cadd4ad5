#include "host/metrics/flip_color.hpp"

#include <catch2/catch.hpp>

using namespace quell::metrics;

namespace {

void requireColor(const Color& color, const Color& expected, double margin) {
  for (std::size_t c = 0; c < 3; ++c) REQUIRE(color[c] == Approx(expected[c]).margin(margin));
}

/// Published CIE L*a*b* values of the sRGB primaries (D65) are given to two decimals.
constexpr double kPublishedMargin = 0.02;

}  // namespace

TEST_CASE("the sRGB response has its published values") {
  requireColor(linearFromSrgb({0.0, 0.5, 1.0}), {0.0, 0.2140411, 1.0}, 1e-7);
  REQUIRE(linearFromSrgb({0.02, 0.0, 0.0})[0] == Approx(0.02 / 12.92));
}

TEST_CASE("L*a*b* of the primaries has its published values") {
  requireColor(labFromLinear({1.0, 1.0, 1.0}), {100.0, 0.0, 0.0}, 1e-9);
  requireColor(labFromLinear({0.0, 0.0, 0.0}), {0.0, 0.0, 0.0}, 1e-9);
  requireColor(labFromLinear({1.0, 0.0, 0.0}), {53.24, 80.09, 67.20}, kPublishedMargin);
  requireColor(labFromLinear({0.0, 1.0, 0.0}), {87.73, -86.18, 83.18}, kPublishedMargin);
  requireColor(labFromLinear({0.0, 0.0, 1.0}), {32.30, 79.19, -107.86}, kPublishedMargin);
}

TEST_CASE("YCxCz is linear, has no chroma for grey, and can be undone") {
  requireColor(ycxczFromLinear({1.0, 1.0, 1.0}), {100.0, 0.0, 0.0}, 1e-9);
  requireColor(ycxczFromLinear({0.25, 0.25, 0.25}), {116.0 * 0.25 - 16.0, 0.0, 0.0}, 1e-9);
  requireColor(linearFromYcxcz(ycxczFromLinear({0.2, 0.7, 0.4})), {0.2, 0.7, 0.4}, 1e-12);
}

TEST_CASE("HyAB adds lightness and chroma distances") {
  REQUIRE(hyabDistance({50.0, 3.0, 0.0}, {40.0, 0.0, 4.0}) == Approx(15.0));
  requireColor(huntAdjusted({50.0, 20.0, -10.0}), {50.0, 10.0, -5.0}, 1e-12);
  // By hand from the published values above: |87.73 - 32.30| + hypot(-75.61 - 25.58, 72.98 + 34.84).
  const double greenToBlue = hyabDistance(huntAdjusted(labFromLinear({0.0, 1.0, 0.0})),
                                          huntAdjusted(labFromLinear({0.0, 0.0, 1.0})));
  REQUIRE(greenToBlue == Approx(203.30).margin(0.05));
}

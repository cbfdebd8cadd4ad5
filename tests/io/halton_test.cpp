#include "host/io/halton.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

using namespace quell::io;

TEST_CASE("the Halton sequence is that of bases 2 and 3") {
  constexpr double kPoints[][2] = {
      {1.0 / 2, 1.0 / 3}, {1.0 / 4, 2.0 / 3}, {3.0 / 4, 1.0 / 9}, {1.0 / 8, 4.0 / 9}};
  for (int i = 0; i < 4; ++i) {
    REQUIRE(halton23(i + 1)[0] == Approx(kPoints[i][0]));
    REQUIRE(halton23(i + 1)[1] == Approx(kPoints[i][1]));
  }
}

TEST_CASE("jitter stays in the pixel, spreads over it and repeats") {
  double sum[2] = {0.0, 0.0};
  std::set<std::array<double, 2>> places;
  for (int frame = 0; frame < kJitterPeriod; ++frame) {
    const std::array<double, 2> offset = jitterPxOf(frame);
    REQUIRE(offset == jitterPxOf(frame + kJitterPeriod));
    places.insert(offset);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      REQUIRE(std::abs(offset[axis]) < 0.5);
      sum[axis] += offset[axis];
    }
  }
  REQUIRE(places.size() == kJitterPeriod);
  for (const double axis : sum) REQUIRE(std::abs(axis / kJitterPeriod) < 0.04);
}

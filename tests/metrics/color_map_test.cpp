#include "host/metrics/color_map.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "host/metrics/display_encoding.hpp"

using quell::io::Image;
using quell::metrics::colorizeMap;
using quell::metrics::luma;

TEST_CASE("the colour map gets brighter from 0 to 1, evenly enough to read in grey") {
  constexpr int kSteps = 100;
  Image map(kSteps + 1, 1, 1);
  for (int x = 0; x <= kSteps; ++x) map.at(x, 0, 0) = float(x) / float(kSteps);
  const Image picture = colorizeMap(map);
  double last = -1.0;
  for (int x = 0; x <= kSteps; ++x) {
    const double brightness =
        luma(double(picture.at(x, 0, 0)), double(picture.at(x, 0, 1)), double(picture.at(x, 0, 2)));
    REQUIRE(brightness > last);
    REQUIRE(brightness == Approx(double(x) / kSteps).margin(0.07));
    last = brightness;
  }
}

TEST_CASE("the colour map clamps, and shows NaN in a colour of its own") {
  Image map(4, 1, 1);
  map.pixels = {-1.0f, 0.0f, 2.0f, std::numeric_limits<float>::quiet_NaN()};
  const Image picture = colorizeMap(map);
  for (int c = 0; c < 3; ++c) REQUIRE(picture.at(0, 0, c) == picture.at(1, 0, c));
  REQUIRE(picture.at(2, 0, 0) == 1.0f);
  REQUIRE(picture.at(3, 0, 1) == 1.0f);
  REQUIRE(picture.at(3, 0, 0) == 0.0f);
}

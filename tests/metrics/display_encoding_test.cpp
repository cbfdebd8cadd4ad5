#include "host/metrics/display_encoding.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace quell::metrics;

TEST_CASE("display encoding clamps and applies the inverse of gamma 2.2") {
  REQUIRE(encodeDisplay(0.0f) == 0.0f);
  REQUIRE(encodeDisplay(1.0f) == 1.0f);
  REQUIRE(encodeDisplay(-3.0f) == 0.0f);
  REQUIRE(encodeDisplay(std::numeric_limits<float>::infinity()) == 1.0f);
  REQUIRE(encodeDisplay(0.5f) == Approx(0.72974005).epsilon(1e-6));
  REQUIRE(std::isnan(encodeDisplay(std::numeric_limits<float>::quiet_NaN())));
}

TEST_CASE("encoding and clamping keep the shape") {
  quell::io::Image image(2, 1, 3);
  image.pixels = {0.0f, 0.25f, 9.0f, -1.0f, 1.0f, 0.5f};
  const quell::io::Image encoded = encodeForDisplay(image);
  REQUIRE(encoded.width == 2);
  REQUIRE(encoded.pixels[1] == encodeDisplay(0.25f));
  REQUIRE(clampEncoded(image).pixels == std::vector<float>{0.0f, 0.25f, 1.0f, 0.0f, 1.0f, 0.5f});
}

TEST_CASE("luma of grey is its value") {
  REQUIRE(luma(0.3, 0.3, 0.3) == Approx(0.3).epsilon(1e-12));
  REQUIRE(luma(0.0, 1.0, 0.0) == 0.7152);
}

TEST_CASE("tone maps and encodings have the values of their sources") {
  using quell::DisplayEncoding;
  using quell::ToneMap;
  const auto grey = [](double value, const quell::DisplayTransform& transform) {
    return displayed({value, value, value}, transform)[1];
  };
  // IEC 61966-2-1: half the light is 188 of 255; the linear part ends at 0.04045.
  CHECK(grey(0.5, {ToneMap::Clamp, DisplayEncoding::Srgb}) == Approx(0.735357).margin(1e-6));
  CHECK(grey(0.0031308, {ToneMap::Clamp, DisplayEncoding::Srgb}) == Approx(0.04045).margin(1e-5));
  CHECK(grey(3.0, {ToneMap::Reinhard, DisplayEncoding::Linear}) == Approx(0.75));
  CHECK(displayed({4.0, 0.0, 0.0}, {ToneMap::Reinhard, DisplayEncoding::Linear})[0] ==
        1.0);  // 4 / (1 + 0.85)
  CHECK(grey(1.0, {ToneMap::Aces, DisplayEncoding::Linear}) == Approx(2.54 / 3.16));
  CHECK(grey(1e4, {ToneMap::Aces, DisplayEncoding::Linear}) == 1.0);
  CHECK(grey(0.25, {ToneMap::None, DisplayEncoding::Linear, 3.0}) == 2.0);
  CHECK(grey(0.25, {}) == Approx(encodeDisplay(0.25f)));
}

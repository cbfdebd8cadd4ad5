#include "host/metrics/temporal.hpp"

#include <catch2/catch.hpp>

#include "tests/support/error_matcher.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::metrics;
using quell::Error;
using quell::ErrorCode;
using quell::io::Image;
using quell::tests::constantImage;
using quell::tests::failsWith;

TEST_CASE("the temporal error is the mean luma difference of consecutive frames") {
  REQUIRE(temporalError({constantImage(4, 3, 0.2f), constantImage(4, 3, 0.5f)}) == Approx(0.3));
  REQUIRE(temporalError({constantImage(4, 3, 0.2f), constantImage(4, 3, 0.5f), constantImage(4, 3, 0.5f)}) ==
          Approx(0.15));
  REQUIRE(temporalError({constantImage(4, 3, 0.2f), constantImage(4, 3, 0.2f)}) == 0.0);
}

TEST_CASE("frames can be given one at a time") {
  TemporalErrorMeter meter;
  meter.add(constantImage(4, 3, 0.2f));
  REQUIRE_FALSE(meter.mean().has_value());
  meter.add(constantImage(4, 3, 0.5f));
  meter.add(constantImage(4, 3, 0.6f));
  REQUIRE(meter.mean().value() == Approx(0.2));
}

TEST_CASE("one green pixel that flashes counts with its luma and its share of the image") {
  const Image dark = constantImage(4, 3, 0.0f);
  Image flash = dark;
  flash.at(2, 1, 1) = 1.0f;
  REQUIRE(meanLumaDifference(dark, flash) == Approx(0.7152 / 12.0));
  REQUIRE(meanLumaDifference(flash, dark) == Approx(0.7152 / 12.0));
}

TEST_CASE("the temporal error needs two frames of one size") {
  REQUIRE_THROWS_MATCHES(temporalError({constantImage(4, 3, 0.2f)}), Error,
                         failsWith(ErrorCode::InvalidArgument, {"two frames"}));
  REQUIRE_THROWS_MATCHES(temporalError({constantImage(4, 3, 0.2f), constantImage(3, 3, 0.2f)}), Error,
                         failsWith(ErrorCode::InvalidArgument));
}

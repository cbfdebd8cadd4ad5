#include "host/metrics/report.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "host/metrics/display_encoding.hpp"
#include "host/metrics/error.hpp"
#include "host/metrics/flip.hpp"
#include "host/metrics/ssim.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::metrics;
using quell::Error;
using quell::ErrorCode;
using quell::io::Image;
using quell::tests::constantImage;
using quell::tests::failsWith;
using quell::tests::noiseImage;

TEST_CASE("a report encodes linear images and takes relMSE before that") {
  const Image image = noiseImage(24, 16, 3, 1, 0.0f, 2.0f);
  const Image a = noiseImage(24, 16, 3, 2), b = noiseImage(24, 16, 3, 3);
  const ErrorFigures figures = compareToReference(image, false, a, b);
  const Image shown = encodeForDisplay(image), reference = encodeForDisplay(meanOfHalves(a, b));
  REQUIRE(figures.rmse == rmse(shown, reference));
  REQUIRE(figures.psnr == Approx(-20.0 * std::log10(figures.rmse)));
  REQUIRE(figures.ssim == ssim(shown, reference));
  REQUIRE(figures.flip == flip(shown, reference));
  REQUIRE(figures.unbiasedRmse.value() == unbiasedRmse(shown, encodeForDisplay(a), encodeForDisplay(b)));
  REQUIRE(figures.relMse.value() == relMse(image, meanOfHalves(a, b)));
  REQUIRE(meanOfMap(flipMapToReference(image, false, a, b)) == figures.flip);
}

TEST_CASE("an encoded image is taken as it is and has no relMSE") {
  const Image reference = noiseImage(24, 16, 3, 2);
  const ErrorFigures figures = compareToReference(encodeForDisplay(reference), true, reference, Image());
  REQUIRE(figures.rmse == 0.0);
  REQUIRE(figures.flip == 0.0);
  REQUIRE(figures.ssim == Approx(1.0));
  REQUIRE_FALSE(figures.relMse.has_value());
  REQUIRE_FALSE(figures.unbiasedRmse.has_value());
}

TEST_CASE("an image without room for an SSIM window still gets its other figures") {
  const ErrorFigures figures =
      compareToReference(constantImage(5, 40, 1.0f), false, constantImage(5, 40, 0.0f), Image());
  REQUIRE(std::isnan(figures.ssim));
  REQUIRE(figures.rmse == 1.0);
}

TEST_CASE("a report refuses images of another size") {
  REQUIRE_THROWS_MATCHES(
      compareToReference(constantImage(5, 4, 1.0f), false, constantImage(4, 5, 0.0f), Image()), Error,
      failsWith(ErrorCode::InvalidArgument, {"5x4", "4x5"}));
  REQUIRE_THROWS_MATCHES(compareToReference(constantImage(5, 4, 1.0f), false, constantImage(5, 4, 0.0f),
                                            constantImage(5, 5, 0.0f)),
                         Error, failsWith(ErrorCode::InvalidArgument, {"5x5"}));
}

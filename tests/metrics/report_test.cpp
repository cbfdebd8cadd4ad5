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
  REQUIRE(figures.at("rmse").value() == rmse(shown, reference));
  REQUIRE(figures.at("psnr").value() == Approx(-20.0 * std::log10(figures.at("rmse").value())));
  REQUIRE(figures.at("ssim").value() == ssim(shown, reference));
  REQUIRE(figures.at("flip").value() == flip(shown, reference));
  REQUIRE(figures.at("unbiased_rmse").value() ==
          unbiasedRmse(shown, encodeForDisplay(a), encodeForDisplay(b)));
  REQUIRE(figures.at("relmse").value() == relMse(image, meanOfHalves(a, b)));
  REQUIRE(meanOfMap(flipMapToReference(image, false, a, b)) == figures.at("flip").value());
}

TEST_CASE("an encoded image is taken as it is and has no relMSE") {
  const Image reference = noiseImage(24, 16, 3, 2);
  const ErrorFigures figures = compareToReference(encodeForDisplay(reference), true, reference, Image());
  REQUIRE(figures.at("rmse").value() == 0.0);
  REQUIRE(figures.at("flip").value() == 0.0);
  REQUIRE(figures.at("ssim").value() == Approx(1.0));
  REQUIRE_FALSE(figures.at("relmse").has_value());
  REQUIRE_FALSE(figures.at("unbiased_rmse").has_value());
}

TEST_CASE("an image without room for an SSIM window still gets its other figures") {
  const ErrorFigures figures =
      compareToReference(constantImage(5, 40, 1.0f), false, constantImage(5, 40, 0.0f), Image());
  REQUIRE_FALSE(figures.at("ssim").has_value());
  REQUIRE(figures.at("rmse").value() == 1.0);
}

TEST_CASE("a report refuses images of another size") {
  REQUIRE_THROWS_MATCHES(
      compareToReference(constantImage(5, 4, 1.0f), false, constantImage(4, 5, 0.0f), Image()), Error,
      failsWith(ErrorCode::InvalidArgument, {"5x4", "4x5"}));
  REQUIRE_THROWS_MATCHES(compareToReference(constantImage(5, 4, 1.0f), false, constantImage(5, 4, 0.0f),
                                            constantImage(5, 5, 0.0f)),
                         Error, failsWith(ErrorCode::InvalidArgument, {"5x5"}));
}

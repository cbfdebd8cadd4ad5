#include "host/metrics/error.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/support/error_matcher.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::metrics;
using quell::Error;
using quell::ErrorCode;
using quell::io::Image;
using quell::tests::constantImage;
using quell::tests::failsWith;
using quell::tests::noiseImage;

namespace {

Image sum(const Image& a, const Image& b, float weightOfB) {
  Image result = a;
  for (std::size_t i = 0; i < result.pixels.size(); ++i) result.pixels[i] += weightOfB * b.pixels[i];
  return result;
}

}  // namespace

TEST_CASE("error measures of constants are what the formulas say") {
  const Image half = constantImage(5, 3, 0.5f), quarter = constantImage(5, 3, 0.25f);
  REQUIRE(rmse(half, quarter) == Approx(0.25));
  REQUIRE(rmse(half, quarter) == rmse(quarter, half));
  REQUIRE(psnr(half, quarter) == Approx(12.0411998));  // 20 log10(4)
  REQUIRE(psnr(constantImage(5, 3, 0.1f), constantImage(5, 3, 0.0f)) == Approx(20.0));
  REQUIRE(relMse(constantImage(5, 3, 2.0f), constantImage(5, 3, 1.0f)) == Approx(1.0 / 1.01));
  REQUIRE(relMse(half, constantImage(5, 3, 0.0f)) == Approx(25.0));
}

TEST_CASE("identical images have no error") {
  const Image image = noiseImage(13, 7, 3, 1);
  REQUIRE(rmse(image, image) == 0.0);
  REQUIRE(std::isinf(psnr(image, image)));
  REQUIRE(relMse(image, image) == 0.0);
  REQUIRE(unbiasedRmse(image, image, noiseImage(13, 7, 3, 2)) == 0.0);
}

TEST_CASE("one wrong sample is averaged over pixels and channels") {
  Image image = constantImage(4, 5, 0.5f);
  image.at(3, 2, 1) = 0.8f;
  REQUIRE(rmse(image, constantImage(4, 5, 0.5f)) == Approx(std::sqrt(0.09 / 60.0)).epsilon(1e-6));
}

TEST_CASE("the unbiased error keeps the sign of the mean product") {
  const Image image = constantImage(3, 3, 0.5f);
  const Image below = constantImage(3, 3, 0.4f), above = constantImage(3, 3, 0.7f);
  REQUIRE(unbiasedMse(image, below, above) == Approx(-0.02).epsilon(1e-6));
  REQUIRE(unbiasedRmse(image, below, above) == Approx(-std::sqrt(0.02)).epsilon(1e-6));
  REQUIRE(unbiasedRmse(image, below, below) == Approx(rmse(image, below)));
}

TEST_CASE("the unbiased error does not see the references' own noise") {
  constexpr int kSize = 128;
  constexpr float kNoise = 0.2f;  // half range of the uniform noise
  const Image truth = noiseImage(kSize, kSize, 3, 1);
  const Image a = sum(truth, noiseImage(kSize, kSize, 3, 2, -1.0f, 1.0f), kNoise);
  const Image b = sum(truth, noiseImage(kSize, kSize, 3, 3, -1.0f, 1.0f), kNoise);
  const double noiseRms = double(kNoise) / std::sqrt(3.0);
  REQUIRE(rmse(truth, meanOfHalves(a, b)) == Approx(noiseRms / std::sqrt(2.0)).epsilon(0.02));
  // The mean of N products of independent noise has standard deviation noiseRms^2 / sqrt(N); 4 of them
  // allowed.
  const double bound = 4.0 * noiseRms * noiseRms / std::sqrt(3.0 * kSize * kSize);
  REQUIRE(std::abs(unbiasedMse(truth, a, b)) < bound);
}

TEST_CASE("the reference is the mean of its halves, or the only one") {
  const Image a = constantImage(2, 2, 0.2f), b = constantImage(2, 2, 0.6f);
  REQUIRE(meanOfHalves(a, b).pixels[0] == Approx(0.4f));
  REQUIRE(meanOfHalves(a, Image()).pixels == a.pixels);
}

TEST_CASE("NaN shows in the result") {
  Image image = constantImage(3, 3, 0.5f);
  image.at(1, 1, 1) = std::numeric_limits<float>::quiet_NaN();
  REQUIRE(std::isnan(rmse(image, constantImage(3, 3, 0.5f))));
}

TEST_CASE("images that cannot be compared are refused") {
  const Image image = constantImage(4, 4, 0.5f);
  REQUIRE_THROWS_MATCHES(rmse(image, constantImage(4, 5, 0.5f)), Error,
                         failsWith(ErrorCode::InvalidArgument, {"4x5", "4x4"}));
  REQUIRE_THROWS_MATCHES(rmse(Image(4, 4, 1), image), Error, failsWith(ErrorCode::InvalidArgument));
  REQUIRE_THROWS_MATCHES(rmse(image, Image()), Error, failsWith(ErrorCode::InvalidArgument, {"reference"}));
  REQUIRE_THROWS_MATCHES(unbiasedMse(image, image, constantImage(3, 4, 0.0f)), Error,
                         failsWith(ErrorCode::InvalidArgument));
}

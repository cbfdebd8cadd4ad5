#include "host/metrics/ssim.hpp"

#include <catch2/catch.hpp>
#include <cmath>

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

double lumaAt(const Image& image, int x, int y) {
  return 0.2126 * double(image.at(x, y, 0)) + 0.7152 * double(image.at(x, y, 1)) +
         0.0722 * double(image.at(x, y, 2));
}

/// The index of Wang et al. 2004 with Gaussian-weighted moments, for the 11x11 window whose top left corner
/// is at (left, top).
double windowSsim(const Image& a, const Image& b, int left, int top) {
  double total = 0.0, meanA = 0.0, meanB = 0.0, varianceA = 0.0, varianceB = 0.0, covariance = 0.0;
  const auto weight = [](int i, int j) {
    return std::exp(-double((i - 5) * (i - 5) + (j - 5) * (j - 5)) / (2.0 * 1.5 * 1.5));
  };
  for (int j = 0; j < 11; ++j)
    for (int i = 0; i < 11; ++i) {
      total += weight(i, j);
      meanA += weight(i, j) * lumaAt(a, left + i, top + j);
      meanB += weight(i, j) * lumaAt(b, left + i, top + j);
    }
  meanA /= total;
  meanB /= total;
  for (int j = 0; j < 11; ++j)
    for (int i = 0; i < 11; ++i) {
      const double da = lumaAt(a, left + i, top + j) - meanA, db = lumaAt(b, left + i, top + j) - meanB;
      varianceA += weight(i, j) / total * da * da;
      varianceB += weight(i, j) / total * db * db;
      covariance += weight(i, j) / total * da * db;
    }
  const double c1 = 1e-4, c2 = 9e-4;
  return (2.0 * meanA * meanB + c1) * (2.0 * covariance + c2) /
         ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
}

double bruteForceSsim(const Image& a, const Image& b) {
  double sum = 0.0;
  for (int top = 0; top + 11 <= a.height; ++top)
    for (int left = 0; left + 11 <= a.width; ++left) sum += windowSsim(a, b, left, top);
  return sum / double((a.width - 10) * (a.height - 10));
}

}  // namespace

TEST_CASE("SSIM agrees with its definition, window by window") {
  for (const auto& [width, height] : {std::pair{23, 17}, {11, 11}, {12, 30}}) {
    const Image a = noiseImage(width, height, 3, 1), b = noiseImage(width, height, 3, 2, 0.3f, 0.9f);
    REQUIRE(ssim(a, b) == Approx(bruteForceSsim(a, b)).epsilon(1e-9));
    REQUIRE(ssim(a, b) == Approx(ssim(b, a)).epsilon(1e-12));
  }
}

TEST_CASE("SSIM is one for identical images and falls with noise") {
  const Image image = noiseImage(30, 20, 3, 1);
  REQUIRE(ssim(image, image) == Approx(1.0).epsilon(1e-12));
  Image little = image, much = image;
  const Image noise = noiseImage(30, 20, 3, 2, -1.0f, 1.0f);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    little.pixels[i] += 0.05f * noise.pixels[i];
    much.pixels[i] += 0.5f * noise.pixels[i];
  }
  REQUIRE(ssim(little, image) < 1.0);
  REQUIRE(ssim(much, image) < ssim(little, image));
}

TEST_CASE("SSIM of constants is its luminance term") {
  const double a = 0.25, b = 0.75;
  REQUIRE(ssim(constantImage(15, 12, 0.25f), constantImage(15, 12, 0.75f)) ==
          Approx((2.0 * a * b + 1e-4) / (a * a + b * b + 1e-4)).epsilon(1e-9));
}

TEST_CASE("SSIM of an inverted image is negative") {
  const Image image = noiseImage(20, 20, 3, 3);
  Image inverted = image;
  for (float& value : inverted.pixels) value = 1.0f - value;
  REQUIRE(ssim(image, inverted) < 0.0);
}

TEST_CASE("SSIM needs room for one window") {
  REQUIRE_FALSE(isLargeEnoughForSsim(Image(10, 50, 3)));
  REQUIRE(isLargeEnoughForSsim(Image(11, 11, 3)));
  REQUIRE_THROWS_MATCHES(ssim(Image(50, 10, 3), Image(50, 10, 3)), Error,
                         failsWith(ErrorCode::InvalidArgument, {"11x11", "50x10"}));
}

#include "host/metrics/flip.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "host/metrics/flip_color.hpp"
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

constexpr double kPi = 3.14159265358979323846;

/// FLIP as written down in the paper: 2-D filters, no separation, one pixel at a time.
class SlowFlip {
 public:
  SlowFlip(const Image& encoded, double pixelsPerDegree) : m_image(encoded), m_ppd(pixelsPerDegree) {}

  /// Hunt-adjusted L*a*b* of the pixel after contrast sensitivity filtering.
  Color perceived(int x, int y) const {
    const int radius = int(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * m_ppd));
    const auto gaussians = [&](double a1, double b1, double a2, double b2) {
      return [=](int i, int j) {
        const double z = double(i * i + j * j) / (m_ppd * m_ppd);
        return a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * z / b1) +
               a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * z / b2);
      };
    };
    Color linear = linearFromYcxcz({weighted(x, y, radius, 0, gaussians(1.0, 0.0047, 0.0, 1e-5)),
                                    weighted(x, y, radius, 1, gaussians(1.0, 0.0053, 0.0, 1e-5)),
                                    weighted(x, y, radius, 2, gaussians(34.1, 0.04, 13.5, 0.025))});
    for (double& value : linear) value = std::clamp(value, 0.0, 1.0);
    return huntAdjusted(labFromLinear(linear));
  }

  /// Answer of the edge (order 1) or point (order 2) detector: length over x and y.
  double feature(int x, int y, int order) const {
    const double sigma = 0.5 * 0.082 * m_ppd;
    const int radius = int(std::ceil(3.0 * sigma));
    const auto kernel = [=](int along, int across) {
      const double g = std::exp(-double(along * along + across * across) / (2.0 * sigma * sigma));
      return order == 1 ? -along * g : (along * along / (sigma * sigma) - 1.0) * g;
    };
    return std::hypot(signNormalized(x, y, radius, [&](int i, int j) { return kernel(i, j); }),
                      signNormalized(x, y, radius, [&](int i, int j) { return kernel(j, i); }));
  }

 private:
  using Weight = std::function<double(int, int)>;

  double channel(int x, int y, std::size_t c) const {
    x = std::clamp(x, 0, m_image.width - 1);
    y = std::clamp(y, 0, m_image.height - 1);
    return ycxczFromLinear(linearFromSrgb(
        {double(m_image.at(x, y, 0)), double(m_image.at(x, y, 1)), double(m_image.at(x, y, 2))}))[c];
  }

  double weighted(int x, int y, int radius, std::size_t c, const Weight& weight) const {
    double sum = 0.0, total = 0.0;
    for (int j = -radius; j <= radius; ++j)
      for (int i = -radius; i <= radius; ++i) {
        sum += weight(i, j) * channel(x + i, y + j, c);
        total += weight(i, j);
      }
    return sum / total;
  }

  double signNormalized(int x, int y, int radius, const Weight& weight) const {
    double positive = 0.0, negative = 0.0, positiveTotal = 0.0, negativeTotal = 0.0;
    for (int j = -radius; j <= radius; ++j)
      for (int i = -radius; i <= radius; ++i) {
        const double w = weight(i, j), value = (channel(x + i, y + j, 0) + 16.0) / 116.0;
        (w > 0.0 ? positive : negative) += w * value;
        (w > 0.0 ? positiveTotal : negativeTotal) += std::abs(w);
      }
    return positive / positiveTotal + negative / negativeTotal;
  }

  const Image& m_image;
  double m_ppd;
};

/// HyAB distance to colour error, as in the paper's color metric.
double colorErrorByHand(double hyab) {
  const double largest = std::pow(hyabDistance(huntAdjusted(labFromLinear({0.0, 1.0, 0.0})),
                                               huntAdjusted(labFromLinear({0.0, 0.0, 1.0}))),
                                  0.7);
  const double difference = std::pow(hyab, 0.7), knee = 0.4 * largest;
  return difference < knee ? 0.95 / knee * difference : 0.95 + (difference - knee) / (largest - knee) * 0.05;
}

double slowFlipAt(const SlowFlip& a, const SlowFlip& b, int x, int y) {
  const double color = colorErrorByHand(hyabDistance(a.perceived(x, y), b.perceived(x, y)));
  const double edges = std::abs(a.feature(x, y, 1) - b.feature(x, y, 1));
  const double points = std::abs(a.feature(x, y, 2) - b.feature(x, y, 2));
  return std::pow(color, 1.0 - std::sqrt(std::max(edges, points) / std::sqrt(2.0)));
}

/// Smooth colour gradients with a sharp vertical edge.
Image pictureWithEdge(int width, int height, int edgeColumn) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.at(x, y, 0) = x < edgeColumn ? 0.2f : 0.7f;
      image.at(x, y, 1) = float(y) / float(height);
      image.at(x, y, 2) = 0.5f;
    }
  return image;
}

}  // namespace

TEST_CASE("FLIP agrees with the paper's definition, pixel by pixel") {
  const Image a = noiseImage(9, 7, 3, 1), b = noiseImage(9, 7, 3, 2);
  for (double pixelsPerDegree : {67.0, 30.0}) {
    const Image map = flipMap(a, b, pixelsPerDegree);
    const SlowFlip slowA(a, pixelsPerDegree), slowB(b, pixelsPerDegree);
    for (const auto& [x, y] : {std::pair{0, 0}, {4, 3}, {8, 6}, {2, 5}})
      REQUIRE(double(map.at(x, y, 0)) == Approx(slowFlipAt(slowA, slowB, x, y)).epsilon(1e-5));
  }
}

TEST_CASE("FLIP of identical images is zero") {
  const Image image = noiseImage(40, 30, 3, 1);
  REQUIRE(flip(image, image) == 0.0);
}

TEST_CASE("FLIP of constants is the compressed HyAB distance") {
  const Image black = constantImage(30, 20, 0.0f), white = constantImage(30, 20, 1.0f);
  REQUIRE(flip(black, white) == Approx(colorErrorByHand(100.0)).epsilon(1e-5));
  REQUIRE(flip(black, white) ==
          Approx(0.967).margin(0.001));  // 0.95 + 0.05 (25.12 - 16.51) / (41.27 - 16.51)
  const double lightness = 116.0 * std::cbrt(linearFromSrgb({0.5, 0.5, 0.5})[0]) - 16.0;
  REQUIRE(flip(constantImage(30, 20, 0.5f), white) ==
          Approx(colorErrorByHand(100.0 - lightness)).epsilon(1e-5));
}

TEST_CASE("FLIP of pure green against pure blue is the largest possible") {
  Image green = constantImage(20, 20, 0.0f), blue = green;
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) green.at(x, y, 1) = blue.at(x, y, 2) = 1.0f;
  REQUIRE(flip(green, blue) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("FLIP is symmetric and stays in [0, 1]") {
  const Image a = noiseImage(50, 40, 3, 1), b = pictureWithEdge(50, 40, 20);
  const Image map = flipMap(a, b);
  REQUIRE(map.pixels == flipMap(b, a).pixels);
  const auto [least, most] = std::minmax_element(map.pixels.begin(), map.pixels.end());
  REQUIRE(*least >= 0.0f);
  REQUIRE(*most <= 1.0f);
  REQUIRE(flip(a, b) > 0.0);
}

TEST_CASE("FLIP finds a small shift less disturbing than noise") {
  const Image picture = pictureWithEdge(60, 40, 30), moved = pictureWithEdge(60, 40, 31);
  Image noisy = picture;
  const Image noise = noiseImage(60, 40, 3, 1, -0.3f, 0.3f);
  for (std::size_t i = 0; i < noisy.pixels.size(); ++i) noisy.pixels[i] += noise.pixels[i];
  REQUIRE(flip(moved, picture) > 0.0);
  REQUIRE(flip(moved, picture) < flip(noisy, picture));
}

TEST_CASE("FLIP of fine noise falls with the viewing distance") {
  const Image grey = constantImage(60, 60, 0.5f), noisy = noiseImage(60, 60, 3, 1);
  REQUIRE(flip(noisy, grey, 120.0) < flip(noisy, grey, 60.0));
  REQUIRE(flip(noisy, grey, 60.0) < flip(noisy, grey, 30.0));
}

TEST_CASE("FLIP refuses what it cannot compare") {
  const Image image = constantImage(8, 8, 0.5f);
  REQUIRE_THROWS_MATCHES(flip(image, constantImage(8, 9, 0.5f)), Error,
                         failsWith(ErrorCode::InvalidArgument, {"8x9"}));
  REQUIRE_THROWS_MATCHES(flip(image, image, 0.0), Error,
                         failsWith(ErrorCode::InvalidArgument, {"pixelsPerDegree"}));
}

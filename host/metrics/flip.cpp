#include "host/metrics/flip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <quell/error.hpp>

#include "host/metrics/flip_color.hpp"
#include "host/metrics/image_checks.hpp"
#include "host/metrics/plane.hpp"

namespace quell::metrics {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kMaxPixelsPerDegree = 1000.0;  // keeps the filters to a few hundred taps

/// Contrast sensitivity of one opponent channel: two Gaussians of visual angle d in degrees (spatial
/// filtering), a1 sqrt(pi/b1) exp(-pi^2 d^2/b1) + a2 sqrt(pi/b2) exp(-pi^2 d^2/b2). a2 = 0: only one.
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr Sensitivity kAchromatic = {1.0, 0.0047, 0.0, 1.0e-5};
constexpr Sensitivity kRedGreen = {1.0, 0.0053, 0.0, 1.0e-5};
constexpr Sensitivity kBlueYellow = {34.1, 0.04, 13.5, 0.025};
constexpr double kWidestScale = kBlueYellow.b1;  // fixes one radius for all channels

constexpr double kRadiusSigmas = 3.0;  // filters end here
/// q_c, exponent of colour differences (paper: color metric).
constexpr double kColorExponent = 0.7;
/// p_c and p_t: this share of the largest colour difference maps to this error (paper: color metric).
constexpr double kCompressionKnee = 0.4;
constexpr double kCompressionValue = 0.95;
/// w, degrees: width of the detectors from peak to trough (paper: feature detection).
constexpr double kFeatureWidthDegrees = 0.082;
/// q_f, exponent of feature differences (paper: feature metric).
constexpr double kFeatureExponent = 0.5;

using Planes = std::array<Plane, 3>;

Planes toYcxcz(const io::Image& encoded) {
  Planes planes = {Plane(encoded.width, encoded.height), Plane(encoded.width, encoded.height),
                   Plane(encoded.width, encoded.height)};
  for (std::size_t i = 0; i < planes[0].values.size(); ++i) {
    Color srgb{};
    for (std::size_t c = 0; c < 3; ++c) srgb[c] = std::clamp(double(encoded.pixels[3 * i + c]), 0.0, 1.0);
    const Color ycxcz = ycxczFromLinear(linearFromSrgb(srgb));
    for (std::size_t c = 0; c < 3; ++c) planes[c].values[i] = ycxcz[c];
  }
  return planes;
}

/// exp(-pi^2 d^2 / b) as a Gaussian: its standard deviation in pixels.
double sigmaOfScalePx(double b, double pixelsPerDegree) {
  return std::sqrt(b / (2.0 * kPi * kPi)) * pixelsPerDegree;
}

/// Each Gaussian of the sum is separable; the filter's total over its window is normalised to one.
Plane filterBySensitivity(const Plane& plane, const Sensitivity& s, double pixelsPerDegree) {
  const int radiusPx = int(std::ceil(kRadiusSigmas * sigmaOfScalePx(kWidestScale, pixelsPerDegree)));
  const auto total = [&](double a, double b) {
    double rowSum = 0.0;
    for (int x = -radiusPx; x <= radiusPx; ++x)
      rowSum += std::exp(-kPi * kPi * double(x * x) / (pixelsPerDegree * pixelsPerDegree * b));
    return a * std::sqrt(kPi / b) * rowSum * rowSum;
  };
  const auto blur = [&](double b) {
    const Kernel kernel = gaussianKernel(sigmaOfScalePx(b, pixelsPerDegree), radiusPx);
    return convolve(plane, kernel, kernel);
  };
  Plane first = blur(s.b1);
  if (s.a2 == 0.0) return first;
  const Plane second = blur(s.b2);
  const double share = total(s.a1, s.b1) / (total(s.a1, s.b1) + total(s.a2, s.b2));
  for (std::size_t i = 0; i < first.values.size(); ++i)
    first.values[i] = share * first.values[i] + (1.0 - share) * second.values[i];
  return first;
}

/// What is left of the colours at the viewing distance, as Hunt-adjusted L*a*b* per pixel.
std::vector<Color> perceivedColors(const Planes& ycxcz, double pixelsPerDegree) {
  const Plane y = filterBySensitivity(ycxcz[0], kAchromatic, pixelsPerDegree);
  const Plane cx = filterBySensitivity(ycxcz[1], kRedGreen, pixelsPerDegree);
  const Plane cz = filterBySensitivity(ycxcz[2], kBlueYellow, pixelsPerDegree);
  std::vector<Color> colors(y.values.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    Color linear = linearFromYcxcz({y.values[i], cx.values[i], cz.values[i]});
    for (double& value : linear) value = std::clamp(value, 0.0, 1.0);
    colors[i] = huntAdjusted(labFromLinear(linear));
  }
  return colors;
}

/// The largest colour difference the display can show: pure green against pure blue.
double largestColorDifference() {
  const Color green = huntAdjusted(labFromLinear({0.0, 1.0, 0.0}));
  const Color blue = huntAdjusted(labFromLinear({0.0, 0.0, 1.0}));
  return std::pow(hyabDistance(green, blue), kColorExponent);
}

/// Compresses the range of large differences: [0, knee] to [0, p_t], the rest to [p_t, 1].
double colorError(double hyab, double largest) {
  const double difference = std::pow(hyab, kColorExponent);
  const double knee = kCompressionKnee * largest;
  if (difference < knee) return kCompressionValue / knee * difference;
  return kCompressionValue + (difference - knee) / (largest - knee) * (1.0 - kCompressionValue);
}

/// A detector's kernel with its positive and its negative weights each normalised to one.
Kernel normalizeSigns(Kernel kernel) {
  double positive = 0.0, negative = 0.0;
  for (double tap : kernel) (tap > 0.0 ? positive : negative) += std::abs(tap);
  for (double& tap : kernel) tap /= tap > 0.0 ? positive : negative;
  return kernel;
}

/// First (edge) or second (point) derivative of a Gaussian, up to scale and sign.
Kernel derivativeKernel(int order, double sigmaPx, int radiusPx) {
  Kernel kernel;
  for (int x = -radiusPx; x <= radiusPx; ++x) {
    const double gaussian = std::exp(-double(x * x) / (2.0 * sigmaPx * sigmaPx));
    kernel.push_back((order == 1 ? -double(x) : double(x * x) / (sigmaPx * sigmaPx) - 1.0) * gaussian);
  }
  return normalizeSigns(kernel);
}

/// Strength of edges (order 1) or points (order 2): the length of the detector's answers along x and y.
Plane featureStrength(const Plane& achromatic, int order, double pixelsPerDegree) {
  const double sigmaPx = 0.5 * kFeatureWidthDegrees * pixelsPerDegree;
  const int radiusPx = int(std::ceil(kRadiusSigmas * sigmaPx));
  const Kernel derivative = derivativeKernel(order, sigmaPx, radiusPx);
  const Kernel smooth = gaussianKernel(sigmaPx, radiusPx);
  Plane strength = convolve(achromatic, derivative, smooth);
  const Plane alongY = convolve(achromatic, smooth, derivative);
  for (std::size_t i = 0; i < strength.values.size(); ++i)
    strength.values[i] = std::hypot(strength.values[i], alongY.values[i]);
  return strength;
}

/// The Y channel of YCxCz, scaled to [0, 1].
Plane normalizedAchromatic(const Planes& ycxcz) {
  constexpr double kOffset = 16.0, kRange = 116.0;
  Plane plane = ycxcz[0];
  for (double& value : plane.values) value = (value + kOffset) / kRange;
  return plane;
}

struct FeatureStrengths {
  Plane edges;
  Plane points;
};

FeatureStrengths detectFeatures(const Planes& ycxcz, double pixelsPerDegree) {
  const Plane achromatic = normalizedAchromatic(ycxcz);
  return {featureStrength(achromatic, 1, pixelsPerDegree), featureStrength(achromatic, 2, pixelsPerDegree)};
}

double featureError(const FeatureStrengths& a, const FeatureStrengths& b, std::size_t i) {
  const double edges = std::abs(a.edges.values[i] - b.edges.values[i]);
  const double points = std::abs(a.points.values[i] - b.points.values[i]);
  return std::pow(std::max(edges, points) / std::sqrt(2.0), kFeatureExponent);
}

}  // namespace

io::Image flipMap(const io::Image& imageEncoded, const io::Image& referenceEncoded, double pixelsPerDegree) {
  requireComparable(imageEncoded, referenceEncoded, "flip");
  if (!(pixelsPerDegree > 0.0 && pixelsPerDegree <= kMaxPixelsPerDegree))
    throw Error(ErrorCode::InvalidArgument,
                {"flip", "pixelsPerDegree", "a number in (0, 1000]", fmt::format("{}", pixelsPerDegree)});
  const Planes image = toYcxcz(imageEncoded);
  const Planes reference = toYcxcz(referenceEncoded);
  const std::vector<Color> imageColors = perceivedColors(image, pixelsPerDegree);
  const std::vector<Color> referenceColors = perceivedColors(reference, pixelsPerDegree);
  const FeatureStrengths imageFeatures = detectFeatures(image, pixelsPerDegree);
  const FeatureStrengths referenceFeatures = detectFeatures(reference, pixelsPerDegree);
  const double largest = largestColorDifference();

  io::Image map(imageEncoded.width, imageEncoded.height, 1);
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    const double color = colorError(hyabDistance(imageColors[i], referenceColors[i]), largest);
    map.pixels[i] = float(std::pow(color, 1.0 - featureError(imageFeatures, referenceFeatures, i)));
  }
  return map;
}

double meanOfMap(const io::Image& map) {
  double sum = 0.0;
  for (float value : map.pixels) sum += double(value);
  return sum / double(map.pixels.size());
}

double flip(const io::Image& imageEncoded, const io::Image& referenceEncoded, double pixelsPerDegree) {
  return meanOfMap(flipMap(imageEncoded, referenceEncoded, pixelsPerDegree));
}

}  // namespace quell::metrics

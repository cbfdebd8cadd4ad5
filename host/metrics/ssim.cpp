#include "host/metrics/ssim.hpp"

#include <fmt/format.h>

#include <quell/error.hpp>

#include "host/metrics/image_checks.hpp"
#include "host/metrics/plane.hpp"

namespace quell::metrics {
namespace {

constexpr int kRadiusPx = kSsimWindowPx / 2;
constexpr double kC1 = (kSsimK1 * kSsimRange) * (kSsimK1 * kSsimRange);
constexpr double kC2 = (kSsimK2 * kSsimRange) * (kSsimK2 * kSsimRange);

/// Weighted first and second moments of both images in one window.
struct WindowMoments {
  double meanX, meanY, meanXX, meanYY, meanXY;
};

/// The index with the exponents and the third constant that the paper settles on (alpha = beta = gamma = 1,
/// C3 = C2 / 2).
double ssimIndex(const WindowMoments& m) {
  const double varianceX = m.meanXX - m.meanX * m.meanX;
  const double varianceY = m.meanYY - m.meanY * m.meanY;
  const double covariance = m.meanXY - m.meanX * m.meanY;
  const double luminance = (2.0 * m.meanX * m.meanY + kC1) / (m.meanX * m.meanX + m.meanY * m.meanY + kC1);
  const double structure = (2.0 * covariance + kC2) / (varianceX + varianceY + kC2);
  return luminance * structure;
}

}  // namespace

bool isLargeEnoughForSsim(const io::Image& image) {
  return image.width >= kSsimWindowPx && image.height >= kSsimWindowPx;
}

double ssim(const io::Image& imageEncoded, const io::Image& referenceEncoded) {
  requireComparable(imageEncoded, referenceEncoded, "ssim");
  if (!isLargeEnoughForSsim(imageEncoded))
    throw Error(ErrorCode::InvalidArgument, {"ssim", "image", "at least 11x11 pixels",
                                             fmt::format("{}x{}", imageEncoded.width, imageEncoded.height)});
  const Plane x = lumaPlane(imageEncoded);
  const Plane y = lumaPlane(referenceEncoded);
  const Kernel window = gaussianKernel(kSsimSigmaPx, kRadiusPx);
  const auto blur = [&](const Plane& plane) { return convolve(plane, window, window); };
  const Plane meanX = blur(x), meanY = blur(y);
  const Plane meanXX = blur(multiply(x, x)), meanYY = blur(multiply(y, y)), meanXY = blur(multiply(x, y));

  double sum = 0.0;
  for (int row = kRadiusPx; row < x.height - kRadiusPx; ++row)
    for (int column = kRadiusPx; column < x.width - kRadiusPx; ++column)
      sum += ssimIndex({meanX.at(column, row), meanY.at(column, row), meanXX.at(column, row),
                        meanYY.at(column, row), meanXY.at(column, row)});
  return sum / (double(x.width - 2 * kRadiusPx) * double(x.height - 2 * kRadiusPx));
}

}  // namespace quell::metrics

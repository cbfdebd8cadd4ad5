#include "host/metrics/error.hpp"

#include <cmath>

#include "host/metrics/image_checks.hpp"

namespace quell::metrics {
namespace {

/// Mean over all samples of term(sample index).
template <typename Term>
double meanOverSamples(const io::Image& shape, Term term) {
  double sum = 0.0;
  for (std::size_t i = 0; i < shape.pixels.size(); ++i) sum += term(i);
  return sum / double(shape.pixels.size());
}

double square(double x) { return x * x; }

}  // namespace

double rmse(const io::Image& image, const io::Image& reference) {
  requireComparable(image, reference, "rmse");
  return std::sqrt(meanOverSamples(
      image, [&](std::size_t i) { return square(double(image.pixels[i]) - double(reference.pixels[i])); }));
}

double unbiasedMse(const io::Image& image, const io::Image& referenceA, const io::Image& referenceB) {
  requireComparable(image, referenceA, "unbiasedMse");
  requireComparable(image, referenceB, "unbiasedMse");
  return meanOverSamples(image, [&](std::size_t i) {
    const double value = double(image.pixels[i]);
    return (value - double(referenceA.pixels[i])) * (value - double(referenceB.pixels[i]));
  });
}

double signedRoot(double value) { return std::copysign(std::sqrt(std::abs(value)), value); }

double unbiasedRmse(const io::Image& image, const io::Image& referenceA, const io::Image& referenceB) {
  return signedRoot(unbiasedMse(image, referenceA, referenceB));
}

double psnr(const io::Image& image, const io::Image& reference) {
  return -20.0 * std::log10(rmse(image, reference));
}

double relMse(const io::Image& imageLinear, const io::Image& referenceLinear) {
  requireComparable(imageLinear, referenceLinear, "relMse");
  return meanOverSamples(imageLinear, [&](std::size_t i) {
    const double reference = double(referenceLinear.pixels[i]);
    return square(double(imageLinear.pixels[i]) - reference) / (square(reference) + kRelMseEpsilon);
  });
}

io::Image meanOfHalves(const io::Image& a, const io::Image& b) {
  if (b.empty()) return a;
  requireComparable(b, a, "meanOfHalves");
  io::Image mean = a;
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) mean.pixels[i] = 0.5f * (a.pixels[i] + b.pixels[i]);
  return mean;
}

}  // namespace quell::metrics

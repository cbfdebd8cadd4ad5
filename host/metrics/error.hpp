// Pixel-wise error measures: means over pixels times 3 channels, accumulated in double precision.
//
// All but relMse() are meant for display-encoded values (display_encoding.hpp). All throw
// Error(InvalidArgument) for images without 3 channels or of different sizes. A NaN sample makes the result
// NaN.
#pragma once

#include "host/io/image.hpp"

namespace quell::metrics {

/// Added to R^2 in relMse() so that black reference pixels do not dominate; radiance squared.
constexpr double kRelMseEpsilon = 0.01;

/// sqrt(mean((I - R)^2)), >= 0.
double rmse(const io::Image& image, const io::Image& reference);

/// mean((I - A)(I - B)) for two independent halves of the reference: its expectation is the squared error
/// against the converged image, free of the references' own noise. May come out negative for a very small
/// error.
double unbiasedMse(const io::Image& image, const io::Image& referenceA, const io::Image& referenceB);

/// The square root with the value's sign: -sqrt(|v|) of a negative v.
double signedRoot(double value);

/// The signedRoot() of unbiasedMse().
double unbiasedRmse(const io::Image& image, const io::Image& referenceA, const io::Image& referenceB);

/// Peak signal-to-noise ratio for values in [0, 1], in dB: -20 log10(rmse); infinite for identical images.
double psnr(const io::Image& image, const io::Image& reference);

/// mean((I - R)^2 / (R^2 + kRelMseEpsilon)) of linear values, >= 0.
double relMse(const io::Image& imageLinear, const io::Image& referenceLinear);

/// (A + B) / 2, the best reference two halves give; A alone if B is empty.
io::Image meanOfHalves(const io::Image& a, const io::Image& b);

}  // namespace quell::metrics

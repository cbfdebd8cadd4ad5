// From linear radiance to what a display is sent, and how bright that looks.
#pragma once

#include <array>

#include "host/core/display_transform.hpp"
#include "host/io/image.hpp"

namespace quell::metrics {

/// Exponent of the display's response; the encoding raises to its inverse. Source: the tone map of Koskela et
/// al. 2019, used by this project for all display-encoded figures.
constexpr double kDisplayGamma = 2.2;

/// Weights of R, G and B in luma, Rec. ITU-R BT.709.
constexpr double kLumaRed = 0.2126;
constexpr double kLumaGreen = 0.7152;
constexpr double kLumaBlue = 0.0722;

/// What the display output shows of linear R, G, B, in double precision: [0, 1], without a tone map up to the encoding of
/// 65504. Formulas and sources: kernels/common/display_encoding.h. Anything but finite numbers is unspecified.
std::array<double, 3> displayed(const std::array<double, 3>& linear, const DisplayTransform& transform);

/// clamp(linear, 0, 1)^(1 / 2.2). NaN stays NaN, so that it shows in every figure computed from it.
float encodeDisplay(float linear);

/// encodeDisplay() of every sample; same shape.
io::Image encodeForDisplay(const io::Image& linear);
/// displayed() of every pixel of an image of 3 channels, clamped to [0, 1]; with the default transform as above.
io::Image encodeForDisplay(const io::Image& linear, const DisplayTransform& transform);

/// Every sample clamped to [0, 1], NaN kept: for images that are display-encoded already.
io::Image clampEncoded(const io::Image& encoded);

/// Rec. 709 luma of encoded R, G, B; in [0, 1] for inputs in [0, 1].
inline double luma(double r, double g, double b) { return kLumaRed * r + kLumaGreen * g + kLumaBlue * b; }

}  // namespace quell::metrics
